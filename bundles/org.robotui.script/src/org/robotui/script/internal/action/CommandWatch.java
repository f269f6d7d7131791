package org.robotui.script.internal.action;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Host;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.api.script.ScriptLine;
import org.robotui.data.Data;
import org.robotui.data.command.Motion;
import org.robotui.data.command.VelocityCommand;

/**
 * What users send to robots of which they have control: goals and other commands one by one, motion from its begin to
 * its end. Both as they went out, within the limits. One thread.
 */
final class CommandWatch {
  /**
   * Something that was done.
   *
   * @param line does the same
   * @param seconds how long it took, and takes the script
   */
  record Done(String line, double seconds) {}

  /** A command port of a robot UI. */
  private record Target(String ruic, SourceId port) {}

  private static final long SILENT_NANOS = 600_000_000L;
  private static final double SEND_SECONDS = 1;

  private final Host host;
  private final BiFunction<Ruic, SourceId, Optional<Envelope<?>>> newest;
  private final Map<Target, Long> seen = new HashMap<>();
  private final Map<Target, Long> heard = new HashMap<>();
  private final Map<Target, MotionTrack> motions = new HashMap<>();

  /** Sees what is sent from now on. */
  CommandWatch(Host host) {
    this(host, Ruic::sent);
  }

  /** The same, with what tells the newest command that went out. */
  CommandWatch(Host host, BiFunction<Ruic, SourceId, Optional<Envelope<?>>> newest) {
    this.host = host;
    this.newest = newest;
    next(0);
    motions.clear();
  }

  /** What was done since it was asked before. */
  List<Done> next(long now) {
    List<Done> done = new ArrayList<>();
    for (Ruic ruic : host.ruics()) {
      ruic.snapshot().ports().stream().filter(p -> p.kind() == PortKind.COMMAND)
          .forEach(p -> look(ruic, new Target(ruic.name(), p.port()), now, done));
    }
    return done;
  }

  /** The end of all motions that are under way. */
  List<Done> end(long now) {
    List<Done> done = new ArrayList<>();
    List.copyOf(motions.keySet()).forEach(target -> end(target, now, done));
    return done;
  }

  private void look(Ruic ruic, Target target, long now, List<Done> done) {
    Optional<Envelope<?>> last = newest.apply(ruic, target.port());
    boolean fresh = last.isPresent() && !Long.valueOf(last.get().sequence()).equals(seen.get(target));
    if (fresh && ruic.authority(target.port().component()).filter(CommandWatch::isUsers).isPresent()) {
      heard.put(target, now);
      sent(ruic, target, last.get().value(), now, done);
    } else if (motions.containsKey(target) && (fresh || now - heard.get(target) > SILENT_NANOS)) {
      end(target, heard.get(target), done);
    }
    last.ifPresent(e -> seen.put(target, e.sequence()));
  }

  private static boolean isUsers(Authority robot) {
    return robot.holder().filter(by -> by.kind() != Principal.Kind.SCRIPT).isPresent();
  }

  private void sent(Ruic ruic, Target target, Data value, long now, List<Done> done) {
    if (value instanceof VelocityCommand velocity && !velocity.equals(velocity.stopped())) {
      Optional.ofNullable(motions.get(target)).ifPresentOrElse(m -> m.next(velocity, now),
          () -> motions.put(target, new MotionTrack(velocity, now)));
    } else if (value instanceof VelocityCommand) {
      end(target, now, done);
    } else if (value instanceof Motion<?>) {
      comment("Joints were moved by hand at", target, done);
    } else {
      robot(ruic, target).map(ValueLiteral::new).flatMap(l -> value instanceof Record r ? l.of(r) : Optional.empty())
          .ifPresentOrElse(words -> done.add(new Done(send(target, words), 0)),
              () -> comment("What was sent has no words in scripts:", target, done));
    }
  }

  private static Optional<String> robot(Ruic ruic, Target target) {
    return ruic.authority(target.port().component()).map(Authority::robot);
  }

  private static String send(Target target, String words) {
    return "send(" + ScriptLine.literal(target.port()) + ", " + words + ", " + ScriptLine.literal(SEND_SECONDS) + ", "
        + ScriptLine.literal(target.ruic()) + ");";
  }

  private static void comment(String words, Target target, List<Done> done) {
    done.add(new Done("// " + words + " " + target.port() + " of " + ScriptLine.literal(target.ruic()) + ".", 0));
  }

  private void end(Target target, long now, List<Done> done) {
    Optional.ofNullable(motions.remove(target)).ifPresent(m -> {
      m.until(now);
      if (m.seconds() > 0) {
        done.add(new Done(m.line(target.port(), target.ruic()), m.seconds()));
      }
    });
  }
}
