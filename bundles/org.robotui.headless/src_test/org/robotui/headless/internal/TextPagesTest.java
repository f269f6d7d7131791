package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.TextUic;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.host.FakeHost;
import org.robotui.testkit.host.FakeRuic;

class TextPagesTest {
  private final FakeHost host = new FakeHost();
  private final TextPages pages = new TextPages(host);

  @Test
  void saysWhatWouldHelpWhereNothingIsConfigured() {
    assertEquals(List.of("no robot is configured; start with -config FILE"), pages.lines(80, 24));
  }

  @Test
  void showsTheViewsOfAllRobotsOneBelowTheOther() {
    host.add(new FakeRuic("a").view("text", lines("first"))).add(new FakeRuic("b").view("text", lines("second")));

    assertEquals(List.of("first", "second"), pages.lines(80, 24));
  }

  @Test
  void eachRobotGetsItsShareOfTheRows() {
    String[] many = Collections.nCopies(50, "x").toArray(String[]::new);
    host.add(new FakeRuic("a").view("text", lines(many))).add(new FakeRuic("b").view("text", lines("last")));

    List<String> shown = pages.lines(80, 20);

    assertEquals(11, shown.size());
    assertEquals("last", shown.getLast());
  }

  @Test
  void keepsControlCharactersAndLongLinesFromTheTerminal() {
    host.add(new FakeRuic("a").view("text", lines("\u001b[2J evil\u0007", "0123456789AB")));

    assertEquals(List.of("\\u001b[2J e", "0123456789A"), pages.lines(11, 24));
  }

  @Test
  void aRobotWithoutTextViewIsSummarised() {
    host.add(new FakeRuic("a").offering(new PortStatus(new SourceId("base", "scan"), PortKind.STREAM, "LaserScan",
        true, 5, 10.04, 0.31, true, 0, "", "360 ranges")));

    List<String> shown = pages.lines(100, 24);

    assertEquals("a  initialized  connected", shown.getFirst());
    assertTrue(shown.get(1).matches(" *base.scan +LaserScan +10.0 Hz +stale 0.3 s +360 ranges"), shown.get(1));
  }

  @Test
  void aRobotThatWaitsSaysHowItStarts() {
    host.add(new FakeRuic("a").waiting());

    assertEquals(List.of("a  not started  it starts when it is shown: --show a"), pages.lines(100, 24));
  }

  @Test
  void aViewForAWindowIsNoFailure() {
    assertEquals("  plan (map) is not shown in a terminal: it needs a window",
        Summary.failure(failed("plan", "map", "type 'map' is not installed; installed are text")));
    assertEquals("  log (text) failed: fenced: did not return within 2 s",
        Summary.failure(failed("log", "text", "fenced: did not return within 2 s")));
  }

  private static ComponentStatus failed(String id, String type, String reason) {
    return new ComponentStatus(id, type, ComponentStatus.Kind.UIC, RuicState.FAILED, reason, Optional.empty());
  }

  @Test
  void aViewThatThrowsFailsAlone() {
    FakeRuic broken = new FakeRuic("a").view("text", new Lines(() -> {
      throw new IllegalStateException("no font");
    }));
    host.add(broken).add(new FakeRuic("b").view("text", lines("fine")));

    assertTrue(pages.lines(80, 24).contains("fine"));

    assertEquals(List.of("surfaceFailed text"), broken.calls());
    assertTrue(pages.lines(200, 24).stream().anyMatch(l -> l.contains("no font")), "the reason is shown");
  }

  @Test
  void aStackOverflowFailsItsViewAlone() {
    FakeRuic broken = new FakeRuic("a").view("text", new Lines(TextPagesTest::endless));
    host.add(broken).add(new FakeRuic("b").view("text", lines("fine")));

    assertTrue(pages.lines(80, 24).contains("fine"));

    assertEquals(List.of("surfaceFailed text"), broken.calls());
  }

  private static List<String> endless() {
    return endless();
  }

  private static TextUic lines(String... lines) {
    return new Lines(() -> List.of(lines));
  }

  private record Lines(java.util.function.Supplier<List<String>> source) implements TextUic {
    @Override
    public List<String> lines(int columns, int rows) {
      return source.get();
    }

    @Override
    public boolean tick(long nowNanos) {
      return true;
    }

    @Override
    public void close() {}
  }
}
