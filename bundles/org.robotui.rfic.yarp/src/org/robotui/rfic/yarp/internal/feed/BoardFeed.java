package org.robotui.rfic.yarp.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Offer;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.convert.BoardModel;
import org.robotui.yarp.bottle.Bottle;

/**
 * A control board: its joints, how they are driven, their limits, and driving them. Its messages have no names of
 * joints, which are asked for first; a board that does not answer has joints with numbers from then on, as names that
 * change would be joints that are no more.
 */
final class BoardFeed implements BoardPart, AutoCloseable {
  private static final long AGAIN_NANOS = Duration.ofSeconds(5).toNanos();

  private final Wires wires;
  private final PortFeed feed;
  private final String chain;
  private final Supplier<Optional<HostPort>> rpc;
  private final PortOutlet<JointModel> models;
  private final BoardDriver driver;
  private volatile Optional<BoardModel> model = Optional.empty();
  private volatile boolean silent;
  private Optional<Offer> commands = Optional.empty(); // guarded by this
  private boolean closed;
  private boolean said;
  private long askedAt = System.nanoTime() - AGAIN_NANOS; // only on the thread that follows

  BoardFeed(Wires wires, PortFeed feed, String port, String chain, Supplier<Optional<HostPort>> rpc, BodyFeed body) {
    this.wires = wires;
    this.feed = feed;
    this.chain = chain;
    this.rpc = rpc;
    feed.offer(port, JointState.class, "its joints", (m, stamp) -> known(m).map(board -> {
      JointState state = board.state(m);
      body.said(this, m, stamp);
      return state;
    }));
    feed.alsoWanted(body::demanded);
    this.driver = new BoardDriver(wires, () -> rpc.get().orElseThrow(), () -> model);
    feed.offer(chain + "/control", JointControl.class, "how its joints are driven",
        (m, stamp) -> known(m).map(board -> {
          driver.seen(BoardModel.modes(m));
          return board.control(m, driver.targets());
        }));
    this.models = feed.offer(chain + "/model", JointModel.class, "the limits of its joints",
        (m, stamp) -> Optional.empty());
    offerCommands();
  }

  /** As soon as the board can be asked, it can be driven. */
  private synchronized void offerCommands() {
    if (commands.isEmpty() && rpc.get().isPresent() && !closed) {
      commands = Optional.of(wires.context().offers().command(new CommandPort<>(chain + "/joints",
          JointCommand.class, Arity.MANY, chain + ": positions or velocities of its joints"), driver));
    }
  }

  /** Before the joints are known there is nothing to say. */
  private Optional<BoardModel> known(Bottle m) {
    if (model.isEmpty() && (silent || rpc.get().isEmpty())) {
      model = Optional.of(BoardModel.unknown(chain, BoardModel.count(m)));
    }
    return model;
  }

  @Override
  public Optional<BoardModel> model() {
    return model;
  }

  @Override
  public Map<Integer, Double> targets() {
    return driver.targets();
  }

  @Override
  public CommandSink<JointCommand> driver() {
    return driver;
  }

  /** Asks for the joints when somebody begins to look at them; blocks. */
  void tick() {
    offerCommands();
    long now = System.nanoTime();
    Optional<HostPort> where = rpc.get();
    if (feed.wanted() && model.isEmpty() && where.isPresent() && now - askedAt >= AGAIN_NANOS) {
      askedAt = now;
      try {
        model = Optional.of(AskedBoard.ask(wires, where.get(), chain));
      } catch (IOException e) {
        silent = true;
      }
    }
    boolean looked = models.demanded();
    if (looked && !said) {
      model.ifPresent(board -> models.publish(board.model(), Optional.empty()));
    }
    said = looked && model.isPresent();
  }

  /** Stops what we drive. */
  @Override
  public void close() {
    driver.close();
    synchronized (this) {
      closed = true;
      commands.ifPresent(Offer::close);
    }
  }
}
