package org.robotui.rfic.recording.internal.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.Lane;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.replay.TrackId;

@Timeout(60)
class SharedTimelineTest {
  private static final long SECOND = 1_000_000_000L;
  private static final PlaySettings STANDING = new PlaySettings(0, false, false);

  @TempDir
  private Path folder;
  private final AtomicLong real = new AtomicLong(77 * SECOND);
  private final SharedTimeline timeline = new SharedTimeline(real::get);

  /** A recording that does not read anything itself. */
  private static final class Track implements PlayedTrack {
    @Override
    public SearchableHistory history() {
      throw new UnsupportedOperationException("nobody searches");
    }

    private final String name;
    private final TimeRange span;
    private final List<Long> moves = new CopyOnWriteArrayList<>();

    Track(String name, long start, long end) {
      this.name = name;
      this.span = new TimeRange(start * SECOND, end * SECOND);
    }

    @Override
    public TrackId id() {
      return new TrackId(name, "base");
    }

    @Override
    public Path file() {
      return Path.of(name);
    }

    @Override
    public String identity() {
      return name;
    }

    @Override
    public TimeRange span() {
      return span;
    }

    @Override
    public List<Lane> lanes() {
      return List.of();
    }

    @Override
    public List<String> problems() {
      return List.of();
    }

    @Override
    public void moved(long time) {
      moves.add(time / SECOND);
    }

    @Override
    public void passed(long time) {
      // nothing grows old
    }

    @Override
    public OptionalLong neighbour(boolean forward, long time, Optional<String> topic) {
      return OptionalLong.empty();
    }
  }

  private static void await(BooleanSupplier condition) throws InterruptedException {
    while (!condition.getAsBoolean()) {
      Thread.sleep(1);
    }
  }

  private static long moved(Seat seat) throws InterruptedException {
    return assertInstanceOf(Turn.Moved.class, seat.await(Seat.NEVER)).time() / SECOND;
  }

  @Test
  void whoReadsSlowlyMakesItLateAndLosesNothing() throws InterruptedException {
    Seat seat = timeline.add(new Track("a", 100, 200), new PlaySettings(0, true, false), folder);
    assertEquals(100, moved(seat));
    seat.arrived(101 * SECOND);
    real.addAndGet(5 * SECOND);
    await(() -> timeline.state().lagging());
    assertEquals(101 * SECOND, timeline.state().position());
    assertInstanceOf(Turn.Deliver.class, seat.await(101 * SECOND));
    seat.look();
    assertInstanceOf(Turn.Look.class, seat.await(102 * SECOND));
    assertEquals(101 * SECOND, seat.hold(), "it does not pass what nobody had asked for before");
    real.addAndGet(3 * SECOND);
    assertEquals(101 * SECOND, timeline.state().position());
    seat.close();
    assertEquals(TimelineState.EMPTY, timeline.state());
  }

  @Test
  void ofManyWishesOnlyTheNewestIsWorkedOn() throws InterruptedException {
    Track track = new Track("a", 100, 200);
    Seat seat = timeline.add(track, STANDING, folder);
    assertEquals(100, moved(seat));
    for (int i = 110; i < 150; i++) {
      timeline.seek(i * SECOND);
    }
    assertEquals(149 * SECOND, timeline.state().position(), "users see at once where they want to be");
    assertFalse(timeline.isThere());
    seat.arrived(Seat.NEVER);
    assertEquals(149, moved(seat));
    seat.arrived(Seat.NEVER);
    await(timeline::isThere);
    assertEquals(List.of(100L, 149L), track.moves);
    timeline.seek(5 * SECOND);
    assertEquals(100, moved(seat), "no further than the span");
    seat.close();
  }

  @Test
  void oneThatJoinsOrLeavesHoldsNobodyUp() throws InterruptedException {
    Seat first = timeline.add(new Track("a", 100, 200), STANDING, folder);
    moved(first);
    Seat second = timeline.add(new Track("b", 150, 250), STANDING, folder);
    first.arrived(Seat.NEVER);
    assertEquals(100, moved(first));
    assertEquals(100, moved(second));
    first.arrived(Seat.NEVER);
    assertFalse(timeline.isThere());
    second.close();
    await(timeline::isThere);
    assertEquals(1, timeline.tracks().size());
    first.close();
  }

  @Test
  void oneThatJoinsLaterIsTakenToWhereTheOthersAre() throws InterruptedException {
    Seat first = timeline.add(new Track("a", 100, 200), STANDING, folder);
    moved(first);
    first.arrived(Seat.NEVER);
    timeline.seek(180 * SECOND);
    assertEquals(180, moved(first));
    first.arrived(Seat.NEVER);
    Seat second = timeline.add(new Track("b", 50, 250), new PlaySettings(0, true, false), folder);
    assertEquals(180 * SECOND, timeline.state().position());
    assertEquals(180, moved(second));
    assertFalse(timeline.state().playing(), "a user had it stand");
    first.close();
    second.close();
  }

  @Test
  void bookmarksAndOffsetsAreThereAgainWithTheRecording() throws IOException, InterruptedException {
    Seat seat = timeline.add(new Track("a", 100, 200), new PlaySettings(10 * SECOND, false, false), folder);
    timeline.mark(new Bookmark(120 * SECOND, "a bump, \"hard\""));
    timeline.mark(new Bookmark(130 * SECOND, "wrong"));
    timeline.unmark(130 * SECOND);
    timeline.shift(new TrackId("a", "base"), 15 * SECOND);
    seat.close();
    assertEquals(List.of(), timeline.state().bookmarks());
    assertTrue(Files.readString(folder.resolve("timeline.json")).contains("a bump"));

    SharedTimeline later = new SharedTimeline(real::get);
    Seat other = later.add(new Track("b", 100, 200), STANDING, folder);
    assertEquals(List.of(), later.state().bookmarks());
    Seat again = later.add(new Track("a", 100, 200), new PlaySettings(20 * SECOND, false, false), folder);
    assertEquals(25 * SECOND, later.tracks().getFirst().offset(), "what a user added, to what is configured now");
    assertEquals(List.of(new Bookmark(135 * SECOND, "a bump, \"hard\"")), later.state().bookmarks());
    other.close();
    again.close();
  }

  @Test
  void notesThatCannotBeUnderstoodAreSetAside() throws IOException, InterruptedException {
    Path file = folder.resolve("timeline.json");
    Files.writeString(file, "{\"recordings\": [{\"recording\": \"a\"}]}");
    Seat seat = timeline.add(new Track("a", 100, 200), STANDING, folder);
    timeline.mark(new Bookmark(120 * SECOND, "new"));
    seat.close();
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(1, files.filter(each -> each.getFileName().toString().contains(".damaged-")).count());
    }
    assertTrue(Files.readString(file).contains("new"));
  }

  @Test
  void listenersHearOfChangesUntilTheyLeave() throws InterruptedException {
    AtomicLong heard = new AtomicLong();
    Subscription subscription = timeline.listen(heard::incrementAndGet);
    Seat seat = timeline.add(new Track("a", 100, 200), STANDING, folder);
    await(() -> heard.get() > 0);
    timeline.speed(1000);
    assertEquals(100, timeline.state().speed());
    long before = heard.get();
    timeline.loop(true);
    await(() -> heard.get() > before);
    subscription.close();
    seat.close();
  }
}
