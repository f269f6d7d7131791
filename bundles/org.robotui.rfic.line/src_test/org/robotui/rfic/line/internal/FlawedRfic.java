package org.robotui.rfic.line.internal;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficWorker;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.Offer;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * A robot interface for the robot of this bundle that can be given a flaw. It is made without the session base, whose
 * users cannot have most of them.
 */
final class FlawedRfic implements Rfic {
  private static final Duration RETRY = Duration.ofMillis(200);
  private static final int SILENCE_MILLIS = 1000;
  private static final Duration END = Duration.ofMillis(1500);

  private final RficContext context;
  private final int port;
  private final Flaw flaw;
  private final RficWorker worker;
  private final Publication<Odometry> poses;
  private final Offer drive;
  private volatile Optional<Socket> link = Optional.empty();
  private volatile boolean wanted;
  private volatile boolean driven;
  private volatile boolean closed;
  private volatile String kept = "";

  FlawedRfic(RficContext context, int port, Flaw flaw) {
    this.context = context;
    this.port = port;
    this.flaw = flaw;
    this.worker = new RficWorker(context, RETRY, this::follow);
    this.poses =
        context.offers().stream(new StreamPort<>("pose", Odometry.class, Arity.MANY, "where it is"), this::demand);
    this.drive = context.offers().command(new CommandPort<>("drive", VelocityCommand.class, Arity.MANY, "drives it"),
        this::send);
  }

  @Override
  public void start() {
    worker.start("port " + port);
    if (flaw == Flaw.GREEN_TOO_EARLY) {
      context.link().report(new LinkState.Connected("port " + port));
    }
  }

  private String follow(BooleanSupplier over) throws IOException {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
    try {
      link = Optional.of(socket);
      if (flaw == Flaw.GREEN_THOUGH_MUTE) {
        context.link().report(new LinkState.Connected("port " + port));
      }
      socket.setSoTimeout(SILENCE_MILLIS);
      BufferedReader in = new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
      if (wanted && flaw != Flaw.FORGETS_DEMAND || flaw == Flaw.ASKS_FOR_ALL || flaw == Flaw.BRINGS_ALL) {
        say("want");
      }
      say(kept);
      for (String line = line(in); line != null && !over.getAsBoolean(); line = line(in)) {
        heard(line);
      }
      return "port " + port + " hung up";
    } finally {
      link = Optional.empty();
      if (flaw != Flaw.LEAVES_SOCKET) {
        socket.close();
      }
    }
  }

  private String line(BufferedReader in) throws IOException {
    while (true) {
      try {
        return in.readLine();
      } catch (SocketTimeoutException e) {
        if (!driven || flaw != Flaw.HEARS_ITSELF) {
          throw e;
        }
      }
    }
  }

  private void heard(String line) {
    String[] words = line.split(" ");
    switch (words[0]) {
      case "hello" -> context.link().report(new LinkState.Connected("port " + port));
      case "tick" -> {}
      case "pose" -> pose(words);
      default -> {
        if (flaw != Flaw.SWALLOWS_GARBAGE) {
          poses.lost(1, "port " + port + " says what is no word of it");
        }
      }
    }
  }

  private void pose(String[] words) {
    double unit = flaw == Flaw.MILLIMETRES ? 1 : 1000;
    Odometry pose = new Odometry(new FrameId(context.robot(), "odom"), new FrameId(context.robot(), "base"),
        RigidTransform.planar(Double.parseDouble(words[2]) / unit, Double.parseDouble(words[3]) / unit, 0),
        Doubles.EMPTY, Vector3.ZERO, Vector3.ZERO, Doubles.EMPTY);
    long nanos = Duration.ofSeconds(Long.parseLong(words[1])).toNanos();
    if (wanted || flaw == Flaw.BRINGS_ALL) {
      poses.publish(pose, Optional.of(new Stamp(nanos, flaw == Flaw.OWN_STAMPS ? ClockKind.WALL : ClockKind.ROBOT)));
    }
  }

  private void demand(boolean now) {
    wanted = now;
    say(now ? "want" : "leave");
  }

  private Sent send(VelocityCommand command) {
    if (closed) {
      return flaw == Flaw.SENDS_AFTER_END ? sendAnew(command) : new Sent.Refused("it is closed");
    }
    driven = !command.equals(VelocityCommand.ZERO);
    double turn = flaw == Flaw.DEGREES ? command.angular().z() : Math.toDegrees(command.angular().z());
    String line = "drive " + command.linear().x() * 1000 + " " + turn;
    if (say(line)) {
      return new Sent.Out();
    }
    kept = flaw == Flaw.KEEPS_COMMANDS ? line : "";
    return new Sent.Refused("port " + port + " is not linked");
  }

  private Sent sendAnew(VelocityCommand command) {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      link = Optional.of(socket);
      return say("drive " + command.linear().x() * 1000 + " 0") ? new Sent.Out() : new Sent.Refused("it is closed");
    } catch (IOException e) {
      return new Sent.Refused(e.getMessage());
    }
  }

  private boolean say(String line) {
    Optional<Socket> to = link;
    if (to.isEmpty() || line.isEmpty()) {
      return false;
    }
    try {
      OutputStream out = to.get().getOutputStream();
      out.write((line + "\n").getBytes(StandardCharsets.UTF_8));
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  @Override
  public void close() {
    if (driven && flaw != Flaw.NEVER_STOPS || flaw == Flaw.STOPS_OTHERS) {
      send(VelocityCommand.ZERO);
    }
    closed = true;
    if (flaw == Flaw.LEAVES_THREAD) {
      context.threads().newThread(() -> LockSupport.parkNanos(Duration.ofSeconds(30).toNanos())).start();
    }
    if (flaw == Flaw.HANGS_AT_END) {
      LockSupport.parkNanos(Duration.ofSeconds(6).toNanos());
    }
    if (flaw != Flaw.LEAVES_OFFERS) {
      poses.close();
      drive.close();
    }
    worker.stop();
    if (flaw != Flaw.LEAVES_SOCKET) {
      link.ifPresent(FlawedRfic::hangUp);
    }
    worker.join(END);
    context.link().report(new LinkState.Disconnected());
  }

  private static void hangUp(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      // it is over in any case
    }
  }
}
