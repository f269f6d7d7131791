package org.robotui.uic.sound.internal.alert;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.Scripts;
import org.robotui.condition.TimedCondition;
import org.robotui.condition.Verdict;
import org.robotui.testkit.FakeScripts;
import org.robotui.uic.sound.internal.tone.Sound;
import org.robotui.uic.sound.internal.tone.Tone;

/** Alerts run scripts, one at a time, and say where they cannot. */
class AlertScriptsTest {
  private static final Optional<Verdict.Holds> LOW = Optional.of(new Verdict.Holds("battery.charge", "is", "0.1"));

  @TempDir
  Path folder;

  private final FakeScripts engine = new FakeScripts();
  private final List<String> told = new ArrayList<>();
  private Optional<Scripts> found = Optional.of(engine);
  private final AlertScripts scripts = new AlertScripts("Natalie", () -> found, Runnable::run, told::add);

  private AlertConfig alert(Path script) {
    return new AlertConfig("Low", "battery charge < 0.2", TimedCondition.parse("battery charge < 0.2", 0).condition(),
        new Sound.Made(Tone.BEEP), 1, "", 0, 0, true, Optional.of(script));
  }

  private AlertConfig home() throws IOException {
    return alert(Files.writeString(folder.resolve("home.js"), "print(alert.name)"));
  }

  @Test
  void theScriptKnowsTheAlertAndItsRobot() throws IOException {
    scripts.begin(home(), LOW);
    assertEquals(List.of("the script home.js of the alert 'Low'"), engine.opened);
    assertEquals(
        "var alert = {name: \"Low\", when: \"battery charge < 0.2\", source: \"battery.charge\", value: \"0.1\", "
            + "ui: \"Natalie\"}; use(\"Natalie\");",
        engine.runs.getFirst().text());
    assertEquals("print(alert.name)", engine.runs.getLast().text());
    engine.end(new ScriptOutcome.Done(Optional.empty(), ""));
    assertTrue(engine.closed);
    assertEquals(List.of(), told);
  }

  @Test
  void oneScriptOfAnAlertRunsAtATime() throws IOException {
    scripts.begin(home(), LOW);
    scripts.begin(home(), LOW);
    assertEquals(1, engine.opened.size());
    engine.end(new ScriptOutcome.Exited(0));
    scripts.begin(home(), LOW);
    assertEquals(2, engine.opened.size());
  }

  @Test
  void whatFailsIsTold() throws IOException {
    scripts.begin(home(), LOW);
    engine.end(new ScriptOutcome.Failed("drive is refused", "home.js", 3));
    scripts.begin(alert(folder.resolve("none.js")), LOW);
    found = Optional.empty();
    scripts.begin(home(), LOW);
    assertEquals("the script of the alert 'Low' failed: home.js:3: drive is refused", told.getFirst());
    assertTrue(told.get(1).endsWith("none.js is not there"), told.get(1));
    assertTrue(told.getLast().contains("no bundle that runs scripts is installed"), told.getLast());
  }

  @Test
  void theEndOfTheViewEndsItsScripts() throws IOException {
    scripts.begin(home(), LOW);
    assertFalse(engine.closed);
    scripts.close();
    assertTrue(engine.closed);
    scripts.begin(home(), LOW);
    assertEquals(1, engine.opened.size());
  }
}
