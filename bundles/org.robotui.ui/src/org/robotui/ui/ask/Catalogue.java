package org.robotui.ui.ask;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.SourceId;

/** What robots have of one kind, asked for again and again in the background. Safe for all threads. */
public final class Catalogue {
  private static final long PERIOD_NANOS = 2_000_000_000L;

  /**
   * Something that a robot has.
   *
   * @param robot where it is offered
   * @param item what it is
   */
  public record Entry(SourceId robot, Browser.Item item) {
    /**
     * Finds the port of the same robot interface.
     *
     * @param ports of several robot interfaces
     * @return the first of the one that has the item
     */
    public Optional<SourceId> among(List<SourceId> ports) {
      return ports.stream().filter(p -> p.component().equals(robot.component())).findFirst();
    }
  }

  /**
   * What is known now.
   *
   * @param robots how many robots can be browsed
   * @param asked whether the robots that there are have been asked yet
   * @param entries what they have, robot after robot
   * @param problems why some have not answered
   */
  public record Listing(int robots, boolean asked, List<Entry> entries, List<String> problems) {
    /**
     * Copies the lists.
     *
     * @param robots how many robots
     * @param asked whether they have been asked
     * @param entries what they have
     * @param problems why not
     */
    public Listing {
      entries = List.copyOf(entries);
      problems = List.copyOf(problems);
    }
  }

  private final BrowseInput input;
  private final Executor background;
  private final Browser.Kind kind;
  private final AtomicBoolean asking = new AtomicBoolean();
  private volatile Listing listing = new Listing(0, false, List.of(), List.of());
  private volatile long askedAt = System.nanoTime() - PERIOD_NANOS;

  /**
   * Nothing is known yet.
   *
   * @param input who can be browsed
   * @param background runs what may block
   * @param kind what to list
   */
  public Catalogue(BrowseInput input, Executor background, Browser.Kind kind) {
    this.input = input;
    this.background = background;
    this.kind = kind;
  }

  /**
   * Asks again where it is time. Never blocks.
   *
   * @param nowNanos {@link System#nanoTime()}
   */
  public void tick(long nowNanos) {
    int robots = input.robots().size();
    boolean other = robots != listing.robots();
    if ((other || nowNanos - askedAt >= PERIOD_NANOS) && asking.compareAndSet(false, true)) {
      askedAt = nowNanos;
      background.execute(this::ask);
    }
  }

  private void ask() {
    try {
      List<BrowseInput.Robot> robots = input.robots();
      List<Entry> entries = new ArrayList<>();
      List<String> problems = new ArrayList<>();
      for (BrowseInput.Robot robot : robots) {
        try {
          robot.browser().list(kind).forEach(item -> entries.add(new Entry(robot.source(), item)));
        } catch (CallException e) {
          problems.add(robot.source().component() + ": " + e.getMessage());
        }
      }
      listing = new Listing(robots.size(), true, entries, problems);
    } finally {
      asking.set(false);
    }
  }

  /**
   * What is known.
   *
   * @return the newest answer
   */
  public Listing listing() {
    return listing;
  }

  /**
   * Asks for more about something.
   *
   * @param entry what
   * @param done is told on a background thread
   */
  public void describe(Entry entry, Consumer<Detail> done) {
    background.execute(() -> done.accept(described(entry)));
  }

  private Detail described(Entry entry) {
    try {
      for (BrowseInput.Robot robot : input.robots()) {
        if (robot.source().equals(entry.robot())) {
          return new Detail.Known(entry, robot.browser().describe(entry.item()));
        }
      }
      return new Detail.Unknown(entry, entry.robot() + " is not connected any more");
    } catch (CallException e) {
      return new Detail.Unknown(entry, e.getMessage());
    }
  }
}
