package org.robotui.rfic.yarp.internal.feed;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Offer;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.rfic.yarp.internal.convert.BoardGroup;
import org.robotui.rfic.yarp.internal.convert.BoardModel;
import org.robotui.yarp.bottle.Bottle;

/**
 * All control boards of a robot as one set of joints, for views that take one: offered as soon as there are two boards.
 * A value is made of the newest messages of all boards when each has said one, or one of them a second; a board that
 * has been silent for two seconds is left out.
 */
final class BodyFeed implements CommandSink<JointCommand>, AutoCloseable {
  /** Names as views call their inputs, so that they are found among those of single boards. */
  static final List<String> NAMES = List.of("joints", "control", "model", "joint_command");
  private static final long OLD_NANOS = Duration.ofSeconds(2).toNanos();

  private record Said(Bottle message, long at) {}

  private final Wires wires;
  private final Map<BoardPart, Optional<Said>> parts = new LinkedHashMap<>(); // guarded by this, as the following
  private final Set<BoardPart> fresh = new HashSet<>();
  private final List<Offer> offers = new ArrayList<>();
  private Optional<Outlets> outlets = Optional.empty();
  private BoardGroup told = new BoardGroup(List.of());
  private boolean closed;

  private record Outlets(PortOutlet<JointState> joints, PortOutlet<JointControl> control,
      PortOutlet<JointModel> model) {}

  BodyFeed(Wires wires) {
    this.wires = wires;
  }

  synchronized void add(BoardPart part) {
    parts.put(part, Optional.empty());
    if (parts.size() == 2 && !closed) {
      outlets = Optional.of(new Outlets(outlet(0, JointState.class, "where the joints of all control boards are"),
          outlet(1, JointControl.class, "how the joints of all control boards are driven"),
          outlet(2, JointModel.class, "the limits of the joints of all control boards")));
      offers.add(wires.context().offers().command(new CommandPort<>(NAMES.get(3), JointCommand.class, Arity.MANY,
          "positions or velocities of joints of any control board"), this));
    }
  }

  private <D extends Data> PortOutlet<D> outlet(int name, Class<D> type, String help) {
    return new PortOutlet<>(wires, NAMES.get(name), type, help, (m, stamp) -> Optional.empty());
  }

  /** Whether somebody looks, so that all boards are to say their messages. */
  synchronized boolean demanded() {
    return outlets.filter(all -> all.joints().demanded() || all.control().demanded() || all.model().demanded())
        .isPresent();
  }

  /** What a board said; on reading threads. */
  synchronized void said(BoardPart part, Bottle message, Optional<Stamp> stamp) {
    if (closed || !demanded()) {
      fresh.clear();
      return;
    }
    long now = System.nanoTime();
    parts.put(part, Optional.of(new Said(message, now)));
    if (!fresh.add(part) || fresh.size() == parts.size()) {
      fresh.clear();
      publish(now, stamp);
    }
  }

  private void publish(long now, Optional<Stamp> stamp) {
    BoardGroup body = body();
    List<JointState.Joint> joints = new ArrayList<>();
    List<JointControl.Joint> control = new ArrayList<>();
    parts.forEach((part, said) -> said.filter(last -> now - last.at() < OLD_NANOS).ifPresent(last -> {
      BoardModel board = body.named(part.model().orElseThrow());
      joints.addAll(board.state(last.message()).joints());
      control.addAll(board.control(last.message(), part.targets()).joints());
    }));
    outlets.ifPresent(all -> {
      all.joints().publish(new JointState(joints), stamp);
      all.control().publish(new JointControl(control), stamp);
    });
  }

  private BoardGroup body() {
    return new BoardGroup(parts.keySet().stream().flatMap(part -> part.model().stream()).toList());
  }

  /** Tells the limits where somebody begins to look at them, and where joints of one more board are known. */
  synchronized void tick() {
    outlets.ifPresent(all -> {
      BoardGroup body = all.model().demanded() ? body() : new BoardGroup(List.of());
      if (!body.equals(told) && !body.boards().isEmpty()) {
        all.model().publish(body.model(), Optional.empty());
      }
      told = body;
    });
  }

  @Override
  public synchronized Sent send(JointCommand command) {
    BoardGroup body = body();
    Map<BoardPart, List<JointCommand.Joint>> shares = new HashMap<>();
    for (JointCommand.Joint joint : command.joints()) {
      Optional<BoardPart> owner =
          parts.keySet().stream().filter(part -> index(body, part, joint.name()).isPresent()).findFirst();
      if (owner.isEmpty()) {
        return new Sent.Refused("no control board is known to have a joint '" + joint.name() + "'");
      }
      BoardPart part = owner.get();
      String own = part.model().orElseThrow().joints().get(index(body, part, joint.name()).getAsInt()).name();
      shares.computeIfAbsent(part, p -> new ArrayList<>())
          .add(new JointCommand.Joint(own, joint.reference(), joint.modes()));
    }
    return command.joints().isEmpty() ? ask(part -> part.driver().send(command))
        : ask(part -> shares.containsKey(part) ? part.driver().send(new JointCommand(shares.get(part)))
            : new Sent.Unneeded());
  }

  private static OptionalInt index(BoardGroup body, BoardPart part, String joint) {
    return part.model().map(board -> body.named(board).index(joint)).orElse(OptionalInt.empty());
  }

  @Override
  public synchronized Sent stop(JointCommand zero, boolean ours) {
    return ask(part -> part.driver().stop(zero, ours));
  }

  private interface Asking {
    Sent of(BoardPart part);
  }

  /** All parts are asked, also after one that refuses. */
  private Sent ask(Asking asking) {
    Sent all = new Sent.Unneeded();
    for (BoardPart part : parts.keySet()) {
      Sent one = asking.of(part);
      all = one instanceof Sent.Unneeded || all instanceof Sent.Refused ? all : one;
    }
    return all;
  }

  @Override
  public synchronized void close() {
    closed = true;
    offers.forEach(Offer::close);
    outlets.ifPresent(all -> List.of(all.joints(), all.control(), all.model()).forEach(PortOutlet::close));
  }
}
