package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ArgumentsTest {
  @Test
  void configurationsReachToTheNextOption() throws Exception {
    Arguments read = Arguments.parse(new String[]{"-config", "a.yaml", "b.yaml", "-json", "-for", "2.5"});

    assertEquals(List.of(Path.of("a.yaml"), Path.of("b.yaml")), read.configurations());
    assertTrue(read.json());
    assertEquals(Optional.of(Duration.ofMillis(2500)), read.limit());
  }

  @Test
  void withoutAnyItRunsAsTextWithoutEnd() throws Exception {
    assertEquals(new Arguments(List.of(), List.of(), false, Optional.empty(), Optional.empty(), Optional.empty(),
        Set.of(), false,
        Optional.empty(), Optional.empty(), false), Arguments.parse(new String[0]));
  }

  @Test
  void recordingsAreFilesOfTheirOwn() throws Exception {
    Arguments read = Arguments.parse(new String[]{"-config", "a.yaml", "-open", "b.bag", "c.mcap", "-json"});
    assertEquals(List.of(Path.of("a.yaml")), read.configurations());
    assertEquals(List.of(Path.of("b.bag"), Path.of("c.mcap")), read.files());
  }

  @Test
  void scriptsAreAskedFor() throws Exception {
    Arguments read = Arguments.parse(new String[]{"-script", "patrol.js", "-scriptsocket"});
    assertEquals(Optional.of(Path.of("patrol.js")), read.script());
    assertTrue(read.scriptSocket() && read.usesScripts());
  }

  @Test
  void robotsThatWaitAreNamedOneByOne() throws Exception {
    assertEquals(Set.of("a", "b c"), Arguments.parse(new String[]{"-show", "a", "-show", "b c"}).shown());
    assertEquals("-show needs a value", wrong("-show"));
  }

  @Test
  void checkNamesAFile() throws Exception {
    assertEquals(Optional.of(Path.of("x.yaml")), Arguments.parse(new String[]{"-check", "x.yaml"}).check());
    assertEquals(Optional.of(Duration.ofSeconds(8)),
        Arguments.parse(new String[]{"-check", "x.yaml", "-live", "8"}).live());
  }

  @Test
  void saysWhatIsWrong() {
    assertEquals("unknown argument -jason", wrong("-jason"));
    assertEquals("-config needs a value", wrong("-config"));
    assertEquals("-reuse is md or csv, not 'xml'", wrong("-reuse", "xml"));
    assertEquals("-check needs a value", wrong("-check", "-json"));
    assertEquals("-for needs a number of seconds from 0 to 1000000000, not 'soon'", wrong("-for", "soon"));
    assertEquals("-for needs a number of seconds from 0 to 1000000000, not 'NaN'", wrong("-for", "NaN"));
  }

  private static String wrong(String... words) {
    return assertThrows(Arguments.Wrong.class, () -> Arguments.parse(words)).getMessage();
  }
}
