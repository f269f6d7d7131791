package org.robotui.core.internal.time;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;

/**
 * Notices that the time of a robot jumped back although nobody said so: a recording that begins anew without a
 * simulated clock, a clock that was set. Where the stamps of all that is heard fall, it is certain; where others go on,
 * somebody has to judge. Simulated time is told by its clock and is not looked at. Safe for all threads; while nothing
 * is suspicious, nobody waits for a lock.
 */
public final class StampWatch {
  /** Several senders of one stream are never quite in step; that is no fall. */
  private static final long FALL_NANOS = 1_000_000_000L;
  /** One message with a wrong stamp is no jump. */
  private static final long AT_LEAST_NANOS = 200_000_000L;
  /** What was sent before the fall may arrive a little after it. */
  private static final long ON_ITS_WAY_NANOS = 300_000_000L;
  /** Who was heard so shortly before the fall is waited for. */
  private static final long LATELY_NANOS = 2_000_000_000L;
  private static final long MOST_DOUBT_NANOS = 1_500_000_000L;
  private static final int MOST_SPEAKERS = 4096;
  private static final int MOST_NAMED = 3;
  private static final long NONE = Long.MIN_VALUE;
  private static final double SECONDS = 1e-9;

  /** Is told what was noticed, on the thread that gave the stamp; must not block. */
  public interface Ear {
    /** All stamps fell, at most by so many seconds. */
    void jumpedBack(double seconds);

    /** Some fell while others go on. Told once for each that falls. */
    void disagree(List<String> fallen, List<String> goingOn, double seconds);
  }

  private static final class Speaker {
    volatile long last;
    volatile long heard;
    boolean fallen; // this and the next under the lock
    long before;

    Speaker(long stamp, long now) {
      last = stamp;
      heard = now;
    }
  }

  private sealed interface Finding {
    record Back(double seconds) implements Finding {}

    record Disagreement(List<String> fallen, List<String> goingOn, double seconds) implements Finding {}
  }

  private final NanoClock clock;
  private final Ear ear;
  private final Map<Object, Speaker> speakers = new ConcurrentHashMap<>();
  private final Set<String> told = new HashSet<>(); // under the lock
  private volatile long doubtedSince = NONE;

  /**
   * A watch that has heard nothing yet.
   *
   * @param clock monotonic
   * @param ear is told
   */
  public StampWatch(NanoClock clock, Ear ear) {
    this.clock = clock;
    this.ear = ear;
  }

  /**
   * A stamp was received.
   *
   * @param speaker who measures, with equals, and a text for users
   * @param stamp of the newest measurement
   */
  public void heard(Object speaker, Stamp stamp) {
    if (stamp.clock() == ClockKind.ROBOT) {
      heard(speaker, stamp.nanos(), clock.nanos());
    }
  }

  private void heard(Object name, long stamp, long now) {
    Speaker known = speakers.get(name);
    if (known == null) {
      if (speakers.size() < MOST_SPEAKERS) {
        speakers.put(name, new Speaker(stamp, now));
      }
    } else if (doubtedSince == NONE && stamp >= known.last - FALL_NANOS) {
      known.last = stamp;
      known.heard = now;
    } else {
      doubt(known, stamp, now).ifPresent(this::tell);
    }
  }

  private void tell(Finding finding) {
    switch (finding) {
      case Finding.Back b -> ear.jumpedBack(b.seconds());
      case Finding.Disagreement d -> ear.disagree(d.fallen(), d.goingOn(), d.seconds());
    }
  }

  private synchronized Optional<Finding> doubt(Speaker speaker, long stamp, long now) {
    if (stamp < speaker.last - FALL_NANOS) {
      speaker.before = speaker.fallen ? speaker.before : speaker.last;
      speaker.fallen = true;
      doubtedSince = doubtedSince == NONE ? now : doubtedSince;
    } else if (speaker.fallen && stamp >= speaker.before - FALL_NANOS) {
      speaker.fallen = false; // two clocks in turn, or one wrong stamp
      doubtedSince = names(s -> s.fallen).isEmpty() ? NONE : doubtedSince;
    }
    speaker.last = stamp;
    speaker.heard = now;
    return doubtedSince == NONE ? Optional.empty() : judge(now);
  }

  private Optional<Finding> judge(long now) {
    long since = doubtedSince;
    List<String> fallen = names(s -> s.fallen);
    List<String> goingOn = names(s -> !s.fallen && s.heard - since > ON_ITS_WAY_NANOS);
    boolean allWentAlong = fallen.size() > 1 && names(s -> !s.fallen && since - s.heard < LATELY_NANOS).isEmpty();
    boolean longEnough = now - since >= MOST_DOUBT_NANOS;
    if (!longEnough && !(allWentAlong && now - since >= AT_LEAST_NANOS)) {
      return Optional.empty();
    }
    double seconds =
        speakers.values().stream().filter(s -> s.fallen).mapToLong(s -> s.before - s.last).max().orElse(0) * SECONDS;
    doubtedSince = NONE;
    if (goingOn.isEmpty()) {
      speakers.clear(); // who has been silent so far will begin anew as well
      told.clear();
      return Optional.of(new Finding.Back(seconds));
    }
    speakers.values().forEach(s -> s.fallen = false);
    return told.addAll(fallen) ? Optional.of(new Finding.Disagreement(few(fallen), few(goingOn), seconds))
        : Optional.empty();
  }

  private List<String> names(Predicate<Speaker> wanted) {
    return speakers.entrySet().stream().filter(e -> wanted.test(e.getValue())).map(e -> e.getKey().toString()).sorted()
        .toList();
  }

  private static List<String> few(List<String> names) {
    List<String> few = new ArrayList<>(names.subList(0, Math.min(MOST_NAMED, names.size())));
    if (names.size() > MOST_NAMED) {
      few.add((names.size() - MOST_NAMED) + " more");
    }
    return List.copyOf(few);
  }
}
