package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.replay.FoundEvent;
import org.robotui.ui.Health;

class EventSearchTest {
  private final PretendSearch service = new PretendSearch();
  private final Deque<Runnable> display = new ArrayDeque<>();
  private final Deque<Runnable> workers = new ArrayDeque<>();
  private final EventSearch search = new EventSearch(display::add, workers::add, () -> Optional.of(service));

  private static List<FoundEvent> events(int count) {
    return IntStream.range(0, count)
        .mapToObj(i -> PretendSearch.event(PretendTimeline.KEIRA, i, i + 0.5, "event " + i)).toList();
  }

  private static void run(Deque<Runnable> tasks) {
    for (Runnable next = tasks.poll(); next != null; next = tasks.poll()) {
      next.run();
    }
  }

  @Test
  void whatIsFoundIsTakenUpOnTheDisplayOnceForAll() {
    service.events = events(3);
    search.start("battery charge < 0.2");
    assertEquals("0 %, nothing found", search.state().words());
    run(workers);
    assertEquals(List.of(), search.state().events(), "the display has not come to it");
    assertEquals(2, display.size(), "one for what came, and one for the end");
    run(display);
    assertEquals(service.events, search.state().events());
    assertEquals("3 events found", search.state().words());
    assertFalse(search.state().running());
  }

  @Test
  void noMoreIsKeptThanAnybodyLooksThrough() {
    service.events = events(EventSearch.MOST + 7);
    search.start("odom stale");
    run(workers);
    run(display);
    assertEquals(EventSearch.MOST, search.state().events().size());
    assertEquals("5007 events found, of which the first 5000 are shown", search.state().words());
  }

  @Test
  void aSearchThatIsStoppedEndsAndAddsNothing() {
    service.events = events(3);
    search.start("odom stale");
    search.stop();
    run(workers);
    run(display);
    assertTrue(service.stopped);
    assertEquals("stopped at 0 %, nothing found", search.state().words());
  }

  @Test
  void theNextSearchTakesThePlaceOfTheOneBefore() {
    service.events = events(3);
    search.start("odom stale");
    search.start("scan stale");
    run(workers);
    run(display);
    assertEquals("scan stale", search.state().condition());
    assertEquals(3, search.state().events().size());
    search.clear();
    assertEquals("", search.state().words());
  }

  @Test
  void whatWentWrongIsSaid() {
    service.events = events(1);
    service.breaks = "run.bag cannot be read any more";
    search.start("odom stale");
    run(workers);
    run(display);
    assertEquals("run.bag cannot be read any more", search.state().words());
    assertEquals(Health.BAD, search.state().health());
    service.breaks = "";
    service.problems = List.of("run.bag: a message could not be read");
    search.start("odom stale");
    run(workers);
    run(display);
    assertEquals("1 event found; run.bag: a message could not be read", search.state().words());
    assertEquals(Health.WARNING, search.state().health());
  }

  @Test
  void withoutTheServiceItIsSaidWhatIsMissing() {
    EventSearch lone = new EventSearch(display::add, workers::add, Optional::empty);
    lone.start("odom stale");
    assertTrue(lone.state().words().contains("install the feature"), lone.state().words());
    assertEquals(Optional.empty(), lone.fault("odom stale"));
  }
}
