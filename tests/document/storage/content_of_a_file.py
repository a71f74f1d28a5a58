"""The content of a file, to be damaged."""

import json
from typing import Any

from workbench.document import Stored
from workbench.document.samples.examples import example
from workbench.document.storage.files import encode


def written_example() -> dict[str, Any]:
    raw: dict[str, Any] = json.loads(encode(Stored(example("circles").document)))
    return raw
