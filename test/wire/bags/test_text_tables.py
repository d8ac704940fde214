"""Which text is a table."""

from __future__ import annotations

import pytest

from cocorosim_ros.wire.bags.text_tables import TABLE_HEAD, is_text_table


@pytest.mark.parametrize(
    "text",
    [
        "t,u,x\n0,1,2\n",
        "t;u\n0,5;1,5\n1,5;2,5\n",
        "t\tu\n0\t1\n",
        "t|u\n0|1\n",
        "# made by a logger\n0.0 1.5e-3 nan\n0.1  2.5 -inf\n",
        "\ufefft,u\r\n0,1\r\n",
        '"time","name","x"\n"0","boat","1"\n',
        "t,u\n0,1\n1,\n",
        "t,u\n" + "0,1\n" * TABLE_HEAD,
    ],
)
def test_tables(text: str) -> None:
    """Columns with any separator, with comments, gaps and quotes; the last line may be cut."""
    assert is_text_table(text.encode()[:TABLE_HEAD])


def test_a_table_of_windows() -> None:
    """UTF-16, which the converter then asks to have saved otherwise."""
    assert is_text_table("t,u\r\n0,1\r\n".encode("utf-16"))


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"t,u,x\n",
        b"# A page\n\nWith words, and a comma.\n",
        b"name: map\nformat: csv\n",
        b"<html>\n<body>\n",
        b"\x00" * 100,
        b"1\n2\n3\n",
        b"PK\x03\x04 a zip file\n1,2\n1,2\n",
    ],
)
def test_what_is_none(content: bytes) -> None:
    """A header alone, prose, YAML, bytes, a single column."""
    assert not is_text_table(content)
