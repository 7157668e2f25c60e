"""What all functions are called with."""

from __future__ import annotations

import logging
from collections.abc import Mapping as AnyMapping
from typing import Callable, Mapping, Optional, Union

import numpy as np

from . import _core

Options = Mapping[str, Union[str, int, float, bool]]
Progress = Callable[[int, int], None]

_logger = logging.getLogger("roomgraph")


def new_call(
    preset: str,
    options: Optional[Options],
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> _core.Call:
    """The same arguments for the extension module."""
    if options is not None and not isinstance(options, AnyMapping):
        raise _core.UsageError(f"the options are {options!r}: give a dict")
    if not isinstance(preset, str):
        raise _core.UsageError(f"the preset is {preset!r}: give a str")
    if not isinstance(threads, (int, np.integer)) or not 0 <= threads < 2**31:
        raise _core.UsageError(f"threads is {threads!r}: give 0, for one per core, or more")
    settings = [(str(name), _text_of(value)) for name, value in (options or {}).items()]
    return _core.Call(preset, settings, int(threads), _tell, progress)


def _text_of(value: Union[str, int, float, bool]) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _tell(is_warning: bool, text: str) -> None:
    _logger.log(logging.WARNING if is_warning else logging.INFO, "%s", text)
