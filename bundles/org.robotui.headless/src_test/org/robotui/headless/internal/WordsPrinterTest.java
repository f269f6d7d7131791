package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.headless.internal.WordsPrinter.Described;

/** What configurations can say is printed with what is usual, groups within groups. */
class WordsPrinterTest {
  private static final Schema ALERT = Schema.of(
      Setting.required("when", new ValueType.Text(), "The condition."),
      Setting.of("sound", new ValueType.WithPlace(new ValueType.Text()), Placed.nowhere("beep"), "What is heard."));
  private static final Described SOUND = new Described("view", "sound", "Sound", "Sounds alerts.",
      Schema.of(Setting.of("volume", new ValueType.Num(0, 1, ""), 0.5, "how loud."),
          Setting.of("alerts", new ValueType.ListOf(new ValueType.Section(ALERT)), List.of(), "The alerts.")),
      List.of());

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  private WordsPrinter printer(boolean json) {
    return new WordsPrinter(new PrintStream(out, true, StandardCharsets.UTF_8), json);
  }

  @Test
  void settingsStandWithWhatIsUsualAndGroupsBelowThem() {
    printer(false).print(SOUND);
    assertEquals("""
        sound (view): Sounds alerts.
          volume: 0.5
              A number from 0 to 1. How loud.
          alerts: []
              A list, each element a section. The alerts.
            when (must be written)
                A text. The condition.
            sound: beep
                A text. What is heard.

        """, out.toString(StandardCharsets.UTF_8));
  }

  @Test
  void programsReadALineForEachSetting() {
    printer(true).print(SOUND);
    List<String> lines = out.toString(StandardCharsets.UTF_8).lines().toList();
    assertEquals(4, lines.size());
    assertEquals("{\"kind\":\"view\",\"type\":\"sound\",\"setting\":\"alerts.sound\",\"expected\":\"a text\","
        + "\"help\":\"What is heard.\",\"needed\":\"no\",\"usual\":\"beep\"}", lines.getLast());
  }

  @Test
  void typesAreListedByKind() {
    printer(false).list(List.of(SOUND, new Described("safety", "safety", "Safety", "Limits.", ALERT, List.of())));
    assertEquals("view\n  sound   Sounds alerts.\n\nsafety\n  safety  Limits.\n", out.toString(StandardCharsets.UTF_8));
  }

  @Test
  void argumentsAreTypesAndTheForm() throws Exception {
    assertEquals(new WordsArguments(List.of("map", "ros"), true),
        WordsArguments.parse(List.of("-words", "map", "ros", "-json")));
    assertThrows(Arguments.Wrong.class, () -> WordsArguments.parse(List.of("-words", "-live")));
  }
}
