"""Large contents, such as a mesh or a picture, as frozen values that are equal where their digest is."""

from functools import cached_property

from workbench.document.errors import DocumentError
from workbench.language import _

MAX_BLOB_BYTES = 64 * 2**20


class Blob(bytes):
    """Some bytes, at most 64 MB, with the SHA-256 that a file keeps them by. Raises DocumentError if more."""

    def __new__(cls, content: bytes) -> "Blob":
        if len(content) > MAX_BLOB_BYTES:
            sentence = _(
                "This has {size:,} bytes; a picture can keep at most {most:,}. Choose a smaller one."
            )
            raise DocumentError("", sentence.format(size=len(content), most=MAX_BLOB_BYTES))
        return super().__new__(cls, content)

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the content, as 64 hexadecimal digits; found once."""
        import hashlib  # here: few documents have blobs, and the first frame waits for this module

        return hashlib.sha256(self).hexdigest()

    def __eq__(self, other: object) -> bool:
        return self.digest == other.digest if isinstance(other, Blob) else super().__eq__(other)

    def __hash__(self) -> int:
        return hash(self.digest)


class Named(Blob):
    """A blob of which only the digest is known: what a text has in its place until the content is there."""

    def __new__(cls, digest: str) -> "Named":
        blob = bytes.__new__(cls, b"")
        blob.__dict__["digest"] = digest
        return blob
