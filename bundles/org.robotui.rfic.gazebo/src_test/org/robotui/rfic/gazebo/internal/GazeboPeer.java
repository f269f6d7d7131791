package org.robotui.rfic.gazebo.internal;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.Motion;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.rfic.Capability;
import org.robotui.testkit.rfic.Peer;
import org.robotui.testkit.rfic.Sample;

/** A simulator in a process of its own: see {@link SimulatorProcess}. */
final class GazeboPeer implements Peer {
  private static final int PATIENCE_SECONDS = 60;
  private static final Optional<Stamp> MEASURED = Optional.of(new Stamp(SimulatorProcess.STAMP, ClockKind.ROBOT));
  private static final Sample POSE = new Sample("odom", new Odometry(new FrameId("robby", "odom"),
      new FrameId("robby", "base_link"), new RigidTransform(new Vector3(2, -1, 0.5), Quaternion.fromYaw(0.2)),
      Doubles.EMPTY, new Vector3(0.2, 0.3, 0.4), new Vector3(-0.1, -0.2, 0.6),
      Doubles.EMPTY), MEASURED);
  private static final Sample SCAN = new Sample("scan", new LaserScan(new FrameId("robby", "laser"), -1, 1, 0.1, 30,
      0, Floats.of(1, Float.NaN, Float.POSITIVE_INFINITY), Floats.EMPTY), MEASURED);

  /** Tests that run at the same time keep apart. */
  private final String partition = UUID.randomUUID().toString();
  private final List<Data> heard = new CopyOnWriteArrayList<>();
  private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
  private Optional<Process> process = Optional.empty();
  private boolean hangs;

  @Override
  public Map<Capability, String> lacks() {
    return Map.of();
  }

  @Override
  public Rfic create(RficContext context) {
    return GazeboCase.rfic(context, Map.of("partition", partition, "velocity", List.of("cmd_vel")));
  }

  @Override
  public void start() throws IOException {
    Process started = new ProcessBuilder(ProcessHandle.current().info().command().orElse("java"), "-Xmx128m",
        "-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"), SimulatorProcess.class.getName(),
        partition).redirectError(ProcessBuilder.Redirect.INHERIT).start();
    process = Optional.of(started);
    THREADS.newThread(() -> read(started.inputReader())).start();
    if (!answer().equals("ready")) {
      throw new IOException("the robot does not start");
    }
  }

  private void read(BufferedReader lines) {
    try (lines) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        if (line.startsWith("heard ")) {
          heard.add(motion(line.substring(6).split(" ")));
        } else if (line.startsWith("= ")) {
          answers.add(line.substring(2)); // all else is what the library logs
        }
      }
    } catch (IOException e) {
      answers.add("it ended: " + e.getMessage());
    }
  }

  private static VelocityCommand motion(String[] words) {
    return new VelocityCommand(vector(words, 0), vector(words, 3));
  }

  private static Vector3 vector(String[] words, int from) {
    return new Vector3(Double.parseDouble(words[from]), Double.parseDouble(words[from + 1]),
        Double.parseDouble(words[from + 2]));
  }

  private String answer() {
    try {
      return Optional.ofNullable(answers.poll(PATIENCE_SECONDS, TimeUnit.SECONDS))
          .orElseThrow(() -> new IllegalStateException("the robot does not answer"));
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  private void order(String line) {
    if (process.isEmpty() || hangs) {
      return;
    }
    try {
      Writer orders = process.get().outputWriter();
      orders.write(line + "\n");
      orders.flush();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private String ask(String question) {
    order(question);
    return answer();
  }

  @Override
  public void kill() {
    process.ifPresent(running -> {
      running.destroyForcibly();
      running.onExit().join();
    });
    process = Optional.empty();
    hangs = false;
    answers.clear();
  }

  @Override
  public void hang() {
    signal("STOP");
    hangs = true;
  }

  @Override
  public void goOn() {
    signal("CONT");
    hangs = false;
  }

  private void signal(String name) {
    try {
      new ProcessBuilder("kill", "-" + name, "" + process.orElseThrow().pid()).start().waitFor();
    } catch (IOException | InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public void garble() {
    order("nonsense");
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }

  @Override
  public void say(Sample sample) {
    order(sample.port());
  }

  @Override
  public int listeners(Sample sample) {
    return Integer.parseInt(ask("listeners " + sample.port()));
  }

  @Override
  public String motionPort() {
    return "cmd_vel";
  }

  @Override
  public Motion<?> motion() {
    return new VelocityCommand(new Vector3(0.1, 0.2, 0.3), new Vector3(0.4, 0.5, 0.6));
  }

  @Override
  public List<Data> heard() {
    return List.copyOf(heard);
  }

  @Override
  public Set<String> registrations() {
    return Set.of(ask("graph").split(";"));
  }

  @Override
  public int links() {
    return process.isEmpty() ? 0 : Integer.parseInt(ask("links"));
  }

  @Override
  public void close() {
    kill();
  }
}
