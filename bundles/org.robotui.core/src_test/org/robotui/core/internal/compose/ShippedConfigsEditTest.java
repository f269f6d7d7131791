package org.robotui.core.internal.compose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.api.config.ValueType;

/** Every single value of every configuration that is shipped, changed and restored. */
class ShippedConfigsEditTest {
  private static final ValueType ANY = new ValueType.Num(0, 1, "");
  private static final String PLAIN = "plain ";

  static List<Path> configs() throws IOException {
    try (Stream<Path> files = Files.list(Path.of("../../configs"))) {
      return files.filter(f -> f.toString().endsWith(".yaml")).sorted().toList();
    }
  }

  /** The paths of scalars that stand in sections, but for those of templates. */
  private static void scalars(Object tree, List<String> path, Map<List<String>, String> found) {
    if (tree instanceof Map<?, ?> map && !map.containsKey("for")) {
      map.forEach((name, value) -> {
        List<String> inner = new ArrayList<>(path);
        inner.add(name.toString());
        scalars(value, inner, found);
      });
    } else if (tree instanceof String text && text.startsWith(PLAIN) && text.length() > PLAIN.length()) {
      found.put(path, text.substring(PLAIN.length()));
    }
  }

  @ParameterizedTest
  @MethodSource("configs")
  void aChangedValueIsAllThatIsDifferentAndRestoredIsAsBefore(Path config) throws IOException, PathEdit.Refusal {
    String text = Files.readString(config);
    Map<List<String>, String> all = new LinkedHashMap<>();
    scalars(YamlTree.of(text), List.of(), all);
    assertFalse(all.isEmpty());
    for (Map.Entry<List<String>, String> value : all.entrySet()) {
      String changed = PathEdit.set(text, value.getKey(), "0.125", ANY);
      assertNotEquals(text, changed);
      assertEquals(YamlTree.with(YamlTree.of(text), value.getKey(), Optional.of(PLAIN + "0.125")),
          YamlTree.of(changed), value::toString);
      assertEquals(new MarkedText(text).comments(), new MarkedText(changed).comments(), value::toString);
      String word = YamlWords.value(value.getValue(), ANY); // quoted also where that is not needed
      assertEquals(text, PathEdit.set(changed, value.getKey(), value.getValue(), ANY).replace(word, value.getValue()),
          value::toString);
    }
  }

  @ParameterizedTest
  @MethodSource("configs")
  void aNewValueLeavesAllLinesAsTheyAreAndIsRemovedAgain(Path config) throws IOException, PathEdit.Refusal {
    String text = Files.readString(config);
    for (String ruic : ((Map<?, ?>) ((Map<?, ?>) YamlTree.of(text)).get("ruics")).keySet().stream()
        .map(Object::toString).filter(n -> !n.contains("$")).toList()) {
      List<String> path = List.of("ruics", ruic, "unheard", "of");
      String changed = PathEdit.set(text, path, "0.125", ANY);
      assertEquals(new MarkedText(text).comments(), new MarkedText(changed).comments());
      assertEquals(text, PathEdit.remove(changed, path.subList(0, 3)), ruic);
    }
  }
}
