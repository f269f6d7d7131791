package org.robotui.testkit.rfic;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.robotui.data.Data;
import org.robotui.data.command.Motion;
import org.robotui.data.command.VelocityCommand;
import org.robotui.geometry.Vector3;

/**
 * A robot in a Java process of its own, which takes velocities at {@code cmd_vel}. The process says {@code = ready}
 * when it is all there, and {@code heard} with the six numbers of each velocity. It reads lines: the name of a sample
 * has it say that, {@code nonsense} what nobody can read; {@code listeners} with the name of a sample, {@code graph}
 * and {@code links} are questions, which it answers by a line that begins with an equals sign.
 */
public abstract class ProcessPeer implements Peer {
  private static final int PATIENCE_SECONDS = 60;

  private final List<Data> heard = new CopyOnWriteArrayList<>();
  private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
  private final Class<?> program;
  private final List<String> arguments;
  private Optional<Process> process = Optional.empty();
  private boolean hangs;

  /**
   * A robot that is away.
   *
   * @param program has a main method
   * @param arguments what that is given
   */
  protected ProcessPeer(Class<?> program, String... arguments) {
    this.program = program;
    this.arguments = List.of(arguments);
  }

  @Override
  public Map<Capability, String> lacks() {
    return Map.of();
  }

  @Override
  public final void start() throws IOException {
    List<String> command = new ArrayList<>(List.of(ProcessHandle.current().info().command().orElse("java"), "-Xmx128m",
        "-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"), program.getName()));
    command.addAll(arguments);
    Process started = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
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
  public final void kill() {
    process.ifPresent(running -> {
      running.destroyForcibly();
      running.onExit().join();
    });
    process = Optional.empty();
    hangs = false;
    answers.clear();
  }

  @Override
  public final void hang() {
    signal("STOP");
    hangs = true;
  }

  @Override
  public final void goOn() {
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
  public final void garble() {
    order("nonsense");
  }

  @Override
  public final void say(Sample sample) {
    order(sample.port());
  }

  @Override
  public final int listeners(Sample sample) {
    return Integer.parseInt(ask("listeners " + sample.port()));
  }

  @Override
  public final String motionPort() {
    return "cmd_vel";
  }

  @Override
  public final Motion<?> motion() {
    return new VelocityCommand(new Vector3(0.1, 0.2, 0.3), new Vector3(0.4, 0.5, 0.6));
  }

  @Override
  public final List<Data> heard() {
    return List.copyOf(heard);
  }

  @Override
  public final Set<String> registrations() {
    return Set.of(ask("graph").split(";"));
  }

  @Override
  public final int links() {
    return process.isEmpty() ? 0 : Integer.parseInt(ask("links"));
  }

  @Override
  public final void close() {
    kill();
  }
}
