package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.Principal;
import org.robotui.testkit.host.FakeRuic;

class StopsTest {
  private static final Principal YOU = new Principal("w", "You", Principal.Kind.WINDOW);

  private final FakeRuic natalie = new FakeRuic("Natalie");
  private final FakeRuic keira = new FakeRuic("Keira");

  @Test
  void robotsThatSeveralRuicsShowCountOnce() {
    natalie.authority().stop(YOU);
    Stops stops = Stops.of(List.of(natalie.authority(), keira.authority(), natalie.authority()));

    assertEquals(new Stops(List.of("Natalie", "Keira"), List.of("Natalie")), stops);
  }

  @Test
  void aloneARobotNeedsNoWordsButItsRelease() {
    natalie.authority().stop(YOU);
    Stops stops = Stops.of(natalie.authorities());

    assertEquals("", stops.words());
    assertEquals("Release Natalie", stops.release());
    assertEquals("STOPPED", stops.button());
  }

  @Test
  void ofManyTheNumberIsSaid() {
    List<String> robots = IntStream.rangeClosed(1, 50).mapToObj(i -> "r" + i).toList();

    assertEquals("Stopped: 48 of 50 robots", new Stops(robots, robots.subList(0, 48)).words());
    assertEquals("STOP ALL  (F12)", new Stops(robots, robots.subList(0, 48)).button(), "two of them can still move");
    assertEquals("Release all", new Stops(robots, robots).release());
    assertEquals("STOP  (F12)", new Stops(robots, List.of()).button());
  }
}
