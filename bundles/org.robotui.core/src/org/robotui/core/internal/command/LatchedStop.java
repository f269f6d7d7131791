package org.robotui.core.internal.command;

import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.port.StreamSource;

/**
 * A stop that stays: says zero to each motion port once, and again where that is called for. Ports on which we drove
 * are told over a reconnection, and until they take it; the others have to report motion. Guarded by its arbiter.
 */
final class LatchedStop {
  private static final long LOOK_NANOS = 100_000_000L;
  /** Between two attempts at a port that refuses: where we drove, and elsewhere. */
  private static final long OURS_NANOS = 200_000_000L;
  private static final long REFUSED_NANOS = 1_000_000_000L;

  private record Told(long at, long generation, boolean linked) {}

  private final Set<SourceId> driven;
  private final Map<CommandTarget<?>, Told> told = new IdentityHashMap<>();

  /** Of one robot; {@code driven} are the ports on which we drove, as far as is known now. */
  LatchedStop(Set<SourceId> driven) {
    this.driven = Set.copyOf(driven);
  }

  /** Says what is to be said now. Returns when to look again. */
  long step(long now, Collection<CommandTarget<?>> targets, Collection<StreamSource<?>> streams) {
    told.keySet().retainAll(targets);
    for (CommandTarget<?> target : targets) {
      if (isDue(now, target, streams)) {
        told.put(target, new Told(now, target.link().generation(), target.link().isUp()));
        target.postStop(isOurs(target));
      }
    }
    return now + LOOK_NANOS;
  }

  private boolean isOurs(CommandTarget<?> target) {
    return driven.contains(target.id());
  }

  private boolean isDue(long now, CommandTarget<?> target, Collection<StreamSource<?>> streams) {
    Told last = told.get(target);
    if (last == null || isLinkedAnew(target, last)) {
      return true;
    }
    long since = now - last.at();
    return switch (target.stopAnswer()) {
      case UNNEEDED -> false;
      case TAKEN -> since >= LOOK_NANOS && MotionReports.since(last.at(), target, streams);
      case LOST -> since >= LOOK_NANOS;
      case REFUSED -> target.link().isUp() && (isOurs(target) ? since >= OURS_NANOS
          : since >= REFUSED_NANOS && MotionReports.since(last.at(), target, streams));
    };
  }

  /** What was said into a broken link has reached nobody. */
  private boolean isLinkedAnew(CommandTarget<?> target, Told last) {
    boolean anew = !last.linked() || target.link().generation() != last.generation();
    return anew && target.link().isUp() && (isOurs(target) || !last.linked());
  }
}
