"""What the compiler makes of the functions that a lowered text calls beside the texts themselves."""

from typing import Any, no_type_check

from workbench.engine import choices, places, sinks


@no_type_check
def register(numba: Any) -> None:
    """Make them known to numba."""
    types, extending = numba.types, numba.extending
    for shared in sinks.SHARED:
        extending.register_jitable(shared)

    @extending.overload(sinks.emit, strict=False)
    def _emit(sink: Any, *values: Any) -> Any:
        return sinks.body(sink.instance_class, len(values))

    @extending.overload(sinks.stopped, strict=False)
    def _stopped(sink: Any) -> Any:
        if sink.instance_class in sinks.STOPPABLE:
            return lambda sink: sink.stop[0] != 0
        return lambda sink: False

    @extending.overload(sinks.tick, strict=False)
    def _tick(sink: Any, slot: Any, block: Any) -> Any:
        return sinks.TICKS[sink.instance_class]

    extending.register_jitable(sinks.probe)

    @extending.overload(places.beside, strict=False)
    def _beside(count: Any, other: Any) -> Any:
        if isinstance(other, types.Float):
            return lambda count, other: types.float64(types.int32(count))
        return lambda count, other: count

    @extending.intrinsic
    def select(_context: Any, taken: Any, new: Any, old: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, values: Any) -> Any:
            flag, value, kept = values
            value = context.cast(builder, value, new, old)
            flag = context.cast(builder, flag, taken, types.boolean)
            if old.bitwidth < 32 or isinstance(new, types.Float) > isinstance(old, types.Float):
                return builder.select(flag, value, kept)
            # LLVM makes a masked store of any choice that it sees through, but not through turned bytes.
            bits = context.get_value_type(types.Integer.from_bitwidth(old.bitwidth))
            mask = builder.bswap(builder.sext(flag, bits))
            value, kept = builder.bitcast(value, bits), builder.bitcast(kept, bits)
            mixed = builder.or_(builder.and_(value, mask), builder.and_(kept, builder.not_(mask)))
            return builder.bitcast(mixed, context.get_value_type(old))

        return old(taken, new, old), generate

    @extending.overload(choices.chosen, strict=False)
    def _chosen(taken: Any, new: Any, old: Any) -> Any:
        return lambda taken, new, old: select(taken, new, old)
