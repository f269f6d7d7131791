package org.robotui.workbench.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ArgumentsTest {
  @Test
  void readsWhatIsOursAndLeavesThePlatformItsOwn() {
    Arguments read = Arguments.parse("-clearPersistedState", "-config", "a.yaml", "b.yaml", "-open", "c.bag", "-for",
        "2", "-screenshot",
        "x.png", "-after", "0.5", "-theme", "light", "-measure", "m.json", "-script", "p.js", "-scriptsocket");

    assertEquals(new Arguments(List.of(Path.of("a.yaml"), Path.of("b.yaml")), List.of(Path.of("c.bag")),
        Optional.of(Duration.ofSeconds(2)),
        Optional.of(Path.of("x.png")), Duration.ofMillis(500), Optional.of("light"),
        Optional.of(Path.of("m.json")), Optional.of(Path.of("p.js")), true), read);
  }

  @Test
  void nobodyAnswersWhereItMakesAPictureOrClosesByItself() {
    assertTrue(Arguments.parse("-config", "a.yaml").isAttended());
    assertFalse(Arguments.parse("-for", "2").isAttended());
    assertFalse(Arguments.parse("-screenshot", "a.png").isAttended());
  }

  @Test
  void saysWhatIsWrong() {
    assertEquals("-theme is dark or light, not 'pink'", wrong("-theme", "pink"));
    assertEquals("-screenshot needs a value", wrong("-screenshot"));
    assertEquals("-after needs a number of seconds from 0 to 1000000, not 'x'", wrong("-after", "x"));
    assertEquals("-for needs a number of seconds from 0 to 1000000, not '-1'",
        wrong("-for", "NaN").replace("NaN", "-1"));
  }

  private static String wrong(String... words) {
    return assertThrows(IllegalArgumentException.class, () -> Arguments.parse(words)).getMessage();
  }
}
