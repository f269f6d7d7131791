package org.robotui.sim;

import java.io.IOException;
import java.io.PrintStream;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.sim.internal.roblets.BoatDemo;
import org.robotui.sim.internal.swarm.Swarm;
import org.robotui.sim.internal.yarp.HumanoidDemo;

/** Starts the demo robot as a program of its own. */
public final class Main {
  private static final int USAGE_ERROR = 2;
  private static final int FAILED = 1;
  private static final Duration CLOSE_TIME = Duration.ofMillis(900);

  private Main() {}

  /**
   * Runs until the process is told to end.
   *
   * @param arguments as {@code --help} explains them
   */
  public static void main(String[] arguments) {
    System.setProperty("java.awt.headless", "true");
    System.exit(run(List.of(arguments), System.out, System.err));
  }

  private static int run(List<String> arguments, PrintStream out, PrintStream err) {
    if (arguments.contains("--help")) {
      out.print(Options.USAGE);
      return 0;
    }
    try {
      return serve(Options.parse(arguments), out, err);
    } catch (IllegalArgumentException e) {
      err.println(e.getMessage());
      err.print(Options.USAGE);
      return USAGE_ERROR;
    } catch (IOException e) {
      err.println("the demo robot cannot start: " + e.getMessage());
      return FAILED;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return FAILED;
    }
  }

  private static int serve(Options options, PrintStream out, PrintStream err)
      throws IOException, InterruptedException {
    Optional<ProcessHandle> parent = Optional.empty();
    if (options.parent().isPresent()) {
      parent = alive(options.parent());
      if (parent.isEmpty()) {
        err.println("process " + options.parent().getAsLong() + " is not there: nothing to run for");
        return FAILED;
      }
    }
    if (options.swarm() > 0) {
      Swarm swarm = Swarm.start(options.swarm(), options.ros(), options.seed());
      ready(Map.of("ROS_MASTER_URI", swarm.master().text()), swarm, swarm::end, parent, out);
      swarm.awaitEnd();
      return 0;
    }
    if (options.boat()) {
      BoatDemo boat = BoatDemo.start(options.robletsPort(), options.seed());
      ready(Map.of(BodyDatagram.BRAIN_VARIABLE, boat.address()), boat, boat::end, parent, out);
      boat.awaitEnd();
      return 0;
    }
    if (options.humanoid().isPresent()) {
      HumanoidDemo humanoid = HumanoidDemo.start(options.humanoid().get(), options.yarpPort());
      ready(Map.of("YARP_NAMESERVER", humanoid.address()), humanoid, humanoid::end, parent, out);
      humanoid.awaitEnd();
      return 0;
    }
    Demo demo = Demo.start(options);
    ready(demo.addresses(), demo, demo::end, parent, out);
    demo.awaitEnd();
    return 0;
  }

  private static void ready(Map<String, String> addresses, AutoCloseable running, Runnable end,
      Optional<ProcessHandle> parent, PrintStream out) {
    Runtime.getRuntime().addShutdownHook(new Thread(() -> closeInTime(running), "shutdown"));
    parent.ifPresent(process -> process.onExit().thenRun(end));
    // in one piece, so that who reads the first line can read all
    out.print(addresses.entrySet().stream().map(variable -> variable + "\n").collect(Collectors.joining()));
    out.flush();
  }

  /** A peer that hangs must not keep the process: what is not closed by then ends with it. */
  private static void closeInTime(AutoCloseable running) {
    Thread closer = Thread.ofPlatform().daemon().name("close").start(() -> close(running));
    try {
      closer.join(CLOSE_TIME);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static void close(AutoCloseable running) {
    try {
      running.close();
    } catch (Exception e) {
      throw new IllegalStateException("the end failed", e);
    }
  }

  private static Optional<ProcessHandle> alive(OptionalLong pid) {
    return ProcessHandle.of(pid.getAsLong()).filter(ProcessHandle::isAlive);
  }
}
