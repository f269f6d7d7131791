package org.robotui.ros.internal.master;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.ros.XmlRpcValue;

class ParameterTreeTest {

  private static final XmlRpcValue ONE = XmlRpcValue.of(1);

  @Test
  void namespacesAreTreesOfParameters() {
    ParameterTree tree = ParameterTree.empty().set("/a/b", ONE).set("/a/c/d", ONE);
    assertEquals(Optional.of(new XmlRpcValue.Struct(Map.of("b", ONE, "c", new XmlRpcValue.Struct(Map.of("d", ONE))))),
        tree.get("/a"));
    assertEquals(List.of("/a/b", "/a/c/d"), tree.names());
    assertEquals(Optional.empty(), tree.get("/a/b/c"));
  }

  @Test
  void aStructReplacesItsNamespace() {
    ParameterTree tree = ParameterTree.empty().set("/a/b", ONE).set("/a", new XmlRpcValue.Struct(Map.of("z", ONE)));
    assertEquals(List.of("/a/z"), tree.names());
  }

  @Test
  void aParameterInTheWayIsReplaced() {
    assertEquals(List.of("/a/b"), ParameterTree.empty().set("/a", ONE).set("/a/b", ONE).names());
  }

  @Test
  void theRootCanOnlyBeANamespace() {
    assertThrows(IllegalArgumentException.class, () -> ParameterTree.empty().set("/", ONE));
  }

  @Test
  void deletingSaysWhetherThereWasOne() {
    ParameterTree tree = ParameterTree.empty().set("/a/b", ONE);
    assertEquals(Optional.empty(), tree.delete("/a/x"));
    assertEquals(List.of(), tree.delete("/a/b").orElseThrow().names());
  }

  @ParameterizedTest
  @CsvSource({"/r/n,speed,/r/speed", "/n,speed,/speed", "/r/n,speed/max,/r/speed/max", "/r/n,/speed,/speed",
      "/r/n,none,", "/,speed,/speed"})
  void theNearestParameterIsFound(String namespace, String key, String found) {
    ParameterTree tree = ParameterTree.empty().set("/speed", ONE).set("/r/speed/min", ONE);
    assertEquals(Optional.ofNullable(found), tree.search(namespace, key));
  }

  @ParameterizedTest
  @CsvSource({"/r/n,a,/r/a", "/r/n,~a,/r/n/a", "/r/n,/a,/a", "/n,a/,/a", "/n,//a//b,/a/b", "n,a,/a"})
  void namesAreResolvedAsSeenFromTheCaller(String caller, String name, String global) {
    assertEquals(global, MasterNames.resolve(caller, name));
  }
}
