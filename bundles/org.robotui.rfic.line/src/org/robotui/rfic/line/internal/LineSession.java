package org.robotui.rfic.line.internal;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.Offer;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.RobotSession;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.Odometry;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.Sockets;

/** One connection to a robot, and the ports that are offered through it. */
final class LineSession implements RobotSession {

  static final StreamPort<Odometry> POSE = new StreamPort<>("pose", Odometry.class, Arity.MANY, "where the robot is");

  static final CommandPort<VelocityCommand> DRIVE =
      new CommandPort<>("drive", VelocityCommand.class, Arity.MANY, "drives the robot");

  /**
   * Shorter than the two seconds in which a robot interface has to end, since a connection that is being made cannot be
   * interrupted.
   */
  private static final Duration CONNECT = Duration.ofMillis(1500);

  private final RficContext context;
  private final LineSettings settings;
  private final Socket socket;
  private final LinkChanges link;
  private final Publication<Odometry> poses;
  private final Offer drive;
  private volatile boolean wanted;
  private boolean driven; // guarded by this
  private boolean closed; // guarded by this

  private LineSession(RficContext context, LineSettings settings, Socket socket) {
    this.context = context;
    this.settings = settings;
    this.socket = socket;
    this.link = new LinkChanges(context.link());
    this.poses = context.offers().stream(POSE, this::demand);
    this.drive = context.offers().command(DRIVE, this::send);
  }

  /** Connects to the robot, which blocks. */
  static LineSession open(RficContext context, LineSettings settings) throws IOException {
    Socket socket = new Socket();
    try {
      Sockets.prepare(socket);
      settings.robot().connect(socket, CONNECT);
      socket.setSoTimeout((int) settings.silence().toMillis());
      return new LineSession(context, settings, socket);
    } catch (IOException | RuntimeException e) {
      Sockets.closeQuietly(socket);
      throw e;
    }
  }

  @Override
  public Optional<String> follow(BooleanSupplier over) throws IOException {
    LineInput input = new LineInput(socket.getInputStream());
    try {
      for (Optional<String> text = input.next(); text.isPresent() && !over.getAsBoolean(); text = input.next()) {
        receive(text.get());
      }
    } catch (SocketTimeoutException e) {
      throw new IOException(settings.robot() + " has said nothing for " + settings.silence().toMillis() / 1000.0 + " s",
          e);
    }
    return Optional.of(settings.robot() + " has closed the connection");
  }

  /** What nobody can read is complained of, and the rest goes on. */
  private void receive(String text) {
    try {
      switch (text.split(" ", 2)[0]) {
        case "hello", "tick" -> link.report(new LinkState.Connected(settings.robot().toString()));
        case "pose" -> publish(text);
        default -> throw new IllegalArgumentException("it says what is no message: " + PeerText.brief(text));
      }
    } catch (IllegalArgumentException e) {
      poses.lost(1, settings.robot() + ": " + e.getMessage());
    }
  }

  private void publish(String text) {
    if (wanted) {
      LineMessages.Pose pose = LineMessages.pose(text, context.robot());
      context.frames().add(pose.frames(), settings.robot().toString());
      poses.publish(pose.odometry(), Optional.of(pose.stamp()));
    }
  }

  /** The robot is asked only for what somebody wants to see. */
  private void demand(boolean now) {
    wanted = now;
    write(now ? "want" : "leave");
  }

  private synchronized Sent send(VelocityCommand command) {
    if (closed) {
      return new Sent.Refused(settings.robot() + " is no longer connected");
    }
    driven = !command.equals(VelocityCommand.ZERO);
    return write(LineMessages.drive(command)) ? new Sent.Out()
        : new Sent.Refused(settings.robot() + " cannot be reached");
  }

  private boolean write(String text) {
    try {
      socket.getOutputStream().write(LineMessages.encoded(text));
      return true;
    } catch (IOException e) {
      return false; // follow() ends by the same error and tells it
    }
  }

  /** Stops the robot only where it was driven from here: somebody else may drive it now. */
  @Override
  public void close() {
    synchronized (this) {
      if (driven) {
        write(LineMessages.drive(VelocityCommand.ZERO));
      }
      closed = true;
    }
    poses.close();
    drive.close();
    Sockets.closeQuietly(socket);
  }
}
