package org.robotui.rfic.rosbridge.internal.call;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.CallException;
import org.robotui.rfic.rosbridge.internal.ParameterNode;
import org.robotui.web.tree.TreeException;

class NodesOfRos2Test {
  private final ParameterNode base = new ParameterNode();
  private final NodesOfRos2 nodes =
      new NodesOfRos2(this::call, () -> List.of("/base/list_parameters", "/silent/list_parameters", "/base/other"));

  private Map<String, Object> call(String service, Map<String, Object> arguments) throws CallException {
    if (!service.startsWith("/base/")) {
      throw new CallException(service + " did not answer");
    }
    try {
      return base.answer(service, arguments);
    } catch (TreeException e) {
      throw new CallException(e.getMessage(), e);
    }
  }

  private void has(String name, int type, String field, Object value) {
    base.values.put(name, Map.of("type", type, field, value));
  }

  @Test
  void aSilentNodeHidesNoneOfTheOthers() throws CallException {
    has("speed", 3, "double_value", 0.5);
    has("a/b", 4, "string_value", "x");
    assertEquals(List.of("/base/a/b", "/base/speed"), nodes.parameters());
    assertEquals(Optional.of("x"), nodes.value("/base/a/b"));
    assertEquals(Optional.empty(), nodes.value("/nobody/speed"));
  }

  @Test
  void aNewValueHasTheTypeOfTheOldOne() throws CallException {
    has("reals", 8, "double_array_value", List.of());
    has("count", 2, "integer_value", 1L);
    nodes.set("/base/reals", List.of(1L, 2.5));
    assertEquals(Map.of("type", 8, "double_array_value", List.of(1.0, 2.5)), base.values.get("reals"));
    nodes.set("/base/count", 2.0);
    assertEquals(Map.of("type", 2, "integer_value", 2L), base.values.get("count"));
    assertEquals("/base/count holds a whole number, not 2.5", refusal("/base/count", 2.5));
    assertEquals("/base/reals holds a list of numbers, not true", refusal("/base/reals", true));
    assertEquals("/base has no parameter gone", refusal("/base/gone", 1L));
  }

  @Test
  void aRefusalIsSaidInTheWordsOfTheNode() {
    has("fixed", 1, "bool_value", true);
    assertEquals("/base refuses: it is fixed", refusal("/base/fixed", false));
  }

  private String refusal(String name, Object value) {
    return assertThrows(CallException.class, () -> nodes.set(name, value)).getMessage();
  }
}
