"""What a person calls the kinds of transforms, and the steps of undo that change chains."""

from workbench.document.transforms.links import Affine, Link, Reflect, Rotate, Scale, Shear, Translate
from workbench.language import _


def title(link: Link) -> str:
    """What a link is called in lists and menus."""
    return _titles()[type(link)]


def _titles() -> dict[type, str]:
    return {
        Translate: _("Translate"),
        Rotate: _("Rotate"),
        Scale: _("Scale"),
        Reflect: _("Reflect"),
        Shear: _("Shear"),
        Affine: _("Matrix"),
    }


def undo_names() -> dict[str, str]:
    """The step of undo for each edit of ``transforms.edits``; that of ``extend`` is the title of its link."""
    return {
        "add_transform": _("Add transform"),
        "remove_transform": _("Remove transform"),
        "remove_transforms": _("Remove transforms"),
        "reorder_transform": _("Change order of transforms"),
        "switch_transform": _("Switch transform"),
        "replace_transform": _("Replace transform"),
        "apply_matrix": _("Transform figures"),
        "apply_to_points": _("Transform points"),
        "bake": _("Bake transforms"),
    }
