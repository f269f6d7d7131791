package org.robotui.core.internal.compose;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.ValueType;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;

class YamlWordsTest {
  private static final ValueType TEXT = new ValueType.Text();

  @Test
  void anyTextIsReadAsItWasWrittenAlsoInBraces() {
    Stream
        .of("Keira", "base.camera:0", "http://host:11311", "", " ", "a: b", "a #b", "#4da3ff", "- x", "true", "No",
            "007", "1e3", "~", "*", "&a", "!t",
            "%d", "@x", "`x`", "[a]", "{a}", "a,b", "a]", "\"", "'", "\\", "a\nb\tc", "ends:", "\u00e4\u00f6", "\u0007",
            "${X:-y}", "?", "|", ">", "a b", "10.0.0.1", "12:30")
        .forEach(text -> {
          Object read = new Yaml(new SafeConstructor(new LoaderOptions()))
              .load("{k: " + YamlWords.text(text) + ", l: [" + YamlWords.text(text) + "]}");
          // 12:30 is a number in base 60 for others; configurations take every text as it stands.
          Object seen = "12:30".equals(text) ? 750 : text;
          assertEquals(Map.of("k", seen, "l", List.of(seen)), read, text);
        });
  }

  @Test
  void numbersAreQuotedOnlyWhereTheyAreTexts() {
    assertEquals("6665", YamlWords.value("6665", new ValueType.Int(1, 65535)));
    assertEquals("\"6665\"", YamlWords.value("6665", TEXT));
    assertEquals("true", YamlWords.value(true, new ValueType.Flag()));
    assertEquals("[laser, \"7\"]",
        YamlWords.value(List.of("laser", "7"), new ValueType.AnyOf(List.of(TEXT, new ValueType.ListOf(TEXT)))));
    assertEquals("{a: 1.5}", YamlWords.value(Map.of("a", "1.5"), new ValueType.MapOf(new ValueType.Num(0, 9, ""))));
  }
}
