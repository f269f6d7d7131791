package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class NewArgumentsTest {
  private static NewArguments parse(String words) throws Arguments.Wrong {
    return NewArguments.parse(List.of(words.split(" ")));
  }

  private static void wrong(String words, String part) {
    String message = assertThrows(Arguments.Wrong.class, () -> parse(words)).getMessage();
    assertTrue(message.contains(part), message);
  }

  @Test
  void allThatCanBeSaid() throws Arguments.Wrong {
    NewArguments all = parse(
        "-new k.yaml -rfic player -called Keira -robot K -set host=a=b -set port=1 -ruic single -views map,camera, "
            + "-connect camera.image=camera:1 -wait 2.5 -dry");
    assertEquals(
        new NewArguments(Path.of("k.yaml"), "player", Map.of("host", "a=b", "port", "1"), "Keira", "K",
            Optional.of("single"),
            Optional.of(List.of("map", "camera")), Map.of("camera.image", "camera:1"), Duration.ofMillis(2500), true),
        all);
  }

  @Test
  void whatIsNotSaidIsLeftToTheRobot() throws Arguments.Wrong {
    NewArguments least = parse("-new k.yaml -rfic ros -called Keira");
    assertEquals(Optional.empty(), least.ruic());
    assertEquals(Optional.empty(), least.views());
    assertEquals(Duration.ofSeconds(15), least.patience());
  }

  @Test
  void whatIsMissingOrWrongIsNamed() {
    wrong("-new k.yaml -called Keira", "-rfic TYPE is missing");
    wrong("-new k.yaml -rfic ros", "-called NAME is missing");
    wrong("-new k.yaml -rfic ros -called K -set host", "such as host=localhost, not 'host'");
    wrong("-new k.yaml -rfic ros -called K -wait soon", "not 'soon'");
    wrong("-new k.yaml -rfic ros -called K -colour red", "unknown argument -colour");
    wrong("-new k.yaml -rfic", "-rfic needs a value");
  }
}
