package org.robotui.core.internal.watch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.core.internal.command.DisplayWatch;
import org.robotui.core.internal.support.ManualClock;

class DisplayWatchdogTest {
  @TempDir
  Path folder;

  private final ManualClock clock = new ManualClock();
  private final DisplayWatch display = new DisplayWatch(clock);
  private final List<String> alerts = new ArrayList<>();
  private SuspectFile suspects;
  private DisplayWatchdog watchdog;

  @BeforeEach
  void start() {
    suspects = new SuspectFile(folder.resolve("new").resolve("suspects.txt"));
    watchdog = watching("org.robotui.uic.map");
  }

  private DisplayWatchdog watching(String bundle) {
    return new DisplayWatchdog(display, name -> Optional.of(bundle), suspects, Runnable::run, alerts::add);
  }

  private void silent(long millis) {
    clock.advanceMillis(millis);
    watchdog.check(clock.nanos());
  }

  @Test
  void applicationWithoutDisplayIsNeverReported() {
    silent(100_000);
    assertEquals(List.of(), alerts);
  }

  @Test
  void oneSilenceIsReportedOnceAndTheNextAgain() {
    display.alive();
    silent(4900);
    assertEquals(0, alerts.size());
    silent(200);
    silent(2000);
    assertEquals(1, alerts.size());
    assertTrue(alerts.getFirst().contains("5.1 s; bundle org.robotui.uic.map holds it up at "), alerts.getFirst());
    display.alive();
    silent(10);
    assertEquals("the display answers again, after 7.1 s; bundle org.robotui.uic.map held it up", alerts.get(1));
    silent(5100);
    assertEquals(3, alerts.size());
  }

  @Test
  void aSilenceThatStoppedSomethingIsReportedAtOnce() {
    display.alive();
    clock.advanceMillis(210);
    display.stoppedSomething();
    silent(90);
    assertTrue(alerts.getFirst()
        .matches("the display has not answered for 0.3 s; bundle org.robotui.uic.map holds it up at .*; "
            + "what its windows moved is stopped"),
        alerts.getFirst());
    display.alive();
    silent(10);
    silent(10);
    assertEquals(List.of("the display answers again, after 0.3 s; bundle org.robotui.uic.map held it up"),
        alerts.subList(1, alerts.size()));
  }

  @Test
  void theWholeSilenceIsToldThoughOnlyItsBeginningWasSeen() {
    display.alive();
    clock.advanceMillis(210);
    display.stoppedSomething();
    silent(10);
    clock.advanceMillis(2680);
    display.alive();
    silent(10);
    assertEquals("the display answers again, after 2.9 s; bundle org.robotui.uic.map held it up", alerts.getLast());
  }

  @Test
  void theNextSilenceIsToldByItsOwnLength() {
    display.alive();
    silent(8000);
    display.alive();
    silent(10);
    silent(5100);
    display.alive();
    silent(10);
    assertTrue(alerts.getLast().startsWith("the display answers again, after 5.1 s"), alerts.getLast());
  }

  @Test
  void aSilenceThatIsOverWhenItIsSeenIsNotBlamedOnAnybody() {
    display.alive();
    clock.advanceMillis(210);
    display.stoppedSomething();
    display.alive();
    silent(10);
    assertEquals(List.of("the display did not answer for a moment: what its windows moved was stopped"), alerts);
  }

  @Test
  void onlyASilenceThatNoBusyMachineExplainsMakesASuspect() throws IOException {
    display.alive();
    silent(9900);
    assertEquals(List.of(), suspects.all());
    silent(200);
    silent(5000);
    assertEquals(List.of("org.robotui.uic.map"), suspects.all(), "remembered once");
  }

  @Test
  void bundlesThatAreNeededAreNamedButNotOfferedToBeLeftOut() throws IOException {
    watchdog = watching("org.robotui.workbench");
    display.alive();
    silent(12_000);
    assertTrue(alerts.getFirst().contains("bundle org.robotui.workbench holds it up at "), alerts.getFirst());
    assertEquals(List.of(), suspects.all());
  }
}
