package org.robotui.uic.body.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.SourceId;
import org.robotui.data.status.BodyState;
import org.robotui.testkit.FakeInput;
import org.robotui.ui.Health;

/** Lines of a body, what is open, what is old, and what was said before. */
class BodyModelTest {
  private static final long SECOND = 1_000_000_000L;
  private static final SourceId BOAT = new SourceId("boat", "body");

  private final FakeInput<BodyState> input = new FakeInput<>();
  private final BodyModel model = new BodyModel(input);
  private long now = 1000 * SECOND;

  private BodyLook say(double heading, boolean failed) {
    now += SECOND;
    input.put(BOAT, Bodies.boat(heading, failed), now, Optional.empty());
    model.tick(now, 3);
    return model.look();
  }

  private static BodyLine line(BodyLook look, String title) {
    return look.lines().stream().filter(l -> l.title().equals(title)).findFirst().orElseThrow();
  }

  @Test
  void parts_are_open_and_messages_closed_until_they_are_turned() {
    assertEquals(List.of("compass", "heading", "gps", "position", "motor", "power", "wind", "wind"),
        say(10, false).lines().stream().map(BodyLine::title).toList());
    model.wish(model.wish().turn("boat.body/gps").turn("boat.body/compass/heading"));
    assertEquals(List.of("compass", "heading", "heading", "rate", "gps", "motor", "power", "wind", "wind"),
        say(10, false).lines().stream().map(BodyLine::title).toList());
    assertEquals("heading 10.0, rate -0.25", model.look().lines().get(1).value());
  }

  @Test
  void what_failed_or_is_old_is_seen_as_such() {
    BodyLook look = say(10, true);
    assertEquals(Health.BAD, line(look, "motor").health());
    assertTrue(line(look, "motor").value().startsWith("failed: IllegalStateException: no fuel  (3 restarts"),
        line(look, "motor")::value);
    assertEquals(Health.STALE, line(look, "power").health());
    assertEquals(Health.STALE, line(look, "wind").health());
    assertEquals(Health.OK, line(look, "position").health());
    model.tick(now + 5 * SECOND, 3);
    assertEquals(Health.STALE, line(model.look(), "position").health(), "nothing has come for five seconds");
    assertEquals(5.12, line(model.look(), "position").age(), 1e-6);
  }

  @Test
  void the_history_of_a_line_has_what_changed_and_its_numbers() {
    model.wish(model.wish().turn("boat.body/compass/heading").select(Optional.of("boat.body/compass/heading/heading")));
    say(10, false);
    say(10, false);
    BodyPast past = say(12, false).detail().orElseThrow();
    assertEquals(List.of(new BodyPast.Moment(0, "12.0"), new BodyPast.Moment(2, "10.0")), past.moments());
    assertEquals(3, past.curve().size());
    assertEquals(12, past.most().orElseThrow());
    model.wish(model.wish().select(Optional.of("boat.body/gone")));
    assertTrue(say(12, false).detail().isEmpty());
  }

  @Test
  void a_search_opens_what_it_finds() {
    model.wish(model.wish().search("THROTTLE"));
    assertEquals(List.of("motor", "power", "throttle"),
        say(10, false).lines().stream().map(BodyLine::title).toList());
    model.wish(model.wish().search("nothing"));
    assertTrue(say(10, false).lines().isEmpty());
  }
}
