"""Trees are made on several threads at once."""

from concurrent.futures import ThreadPoolExecutor

from workbench.engine.parsing import parse_expression, parse_module

SOURCE = "\n".join(f"def f{k}(x):\n    return [x + {k}, (x * {k}, -x)]" for k in range(200))


def test_many_threads_parse_at_once_and_get_the_same_tree():
    with ThreadPoolExecutor(8) as pool:
        trees = list(pool.map(parse_module, [SOURCE] * 40))
    assert {len(tree.body) for tree in trees} == {200}
    assert parse_expression("1 + 2").lineno == 1
