package org.robotui.sim.internal.yarp;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.robotui.yarp.name.NameServer;

/**
 * A humanoid that stands: a name server of its own on loopback, and a control board for each part of the body, as the
 * robots have it for which YARP was made. A thread lets time pass.
 */
public final class HumanoidDemo implements AutoCloseable {
  private static final long STEP_MILLIS = 20;
  private static final double LONGEST = 0.1;
  private static final double NANOS = 1e-9;
  private static final double MILLIS = 1e-3;

  private final NameServer server;
  private final YarpBench bench;
  private final HumanoidParts humanoid;
  private final Map<String, ControlBoard> boards = new LinkedHashMap<>();
  private final CountDownLatch end = new CountDownLatch(1);
  private final Thread time = thread(this::run);

  private HumanoidDemo(HumanoidParts humanoid, int port) throws IOException {
    this.humanoid = humanoid;
    server = new NameServer(InetAddress.getLoopbackAddress(), port, HumanoidDemo::thread);
    bench = new YarpBench("/" + humanoid.name(), server, HumanoidDemo::thread);
  }

  /**
   * Starts it; all ports are registered when this returns.
   *
   * @param urdf how it is built; the groups of the SRDF beside it are its parts
   * @param port where the name server listens; 0 for a free one
   */
  public static HumanoidDemo start(Path urdf, int port) throws IOException {
    HumanoidDemo demo = new HumanoidDemo(HumanoidParts.read(urdf), port);
    try {
      demo.open();
    } catch (IOException | RuntimeException e) {
      demo.close();
      throw e;
    }
    demo.time.start();
    return demo;
  }

  private void open() throws IOException {
    for (Map.Entry<String, PartJoints> part : humanoid.parts().entrySet()) {
      ControlBoard board = new ControlBoard(part.getValue());
      boards.put(part.getKey(), board);
      bench.board(part.getKey(), board);
    }
  }

  private static Thread thread(Runnable task) {
    return Thread.ofPlatform().daemon().unstarted(task);
  }

  private void run() {
    try {
      long begin = System.nanoTime();
      long last = begin;
      while (!end.await(STEP_MILLIS, TimeUnit.MILLISECONDS)) {
        long now = System.nanoTime();
        double dt = Math.min(LONGEST, (now - last) * NANOS);
        double sinceBegin = (now - begin) * NANOS;
        last = now;
        humanoid.parts().values().forEach(part -> part.step(sinceBegin, dt));
        double seconds = System.currentTimeMillis() * MILLIS;
        boards.forEach((part, board) -> bench.say(part, board, seconds));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Where clients find it. */
  public String address() {
    return "127.0.0.1:" + server.port();
  }

  /** Lets {@link #awaitEnd} return. */
  public void end() {
    end.countDown();
  }

  public void awaitEnd() throws InterruptedException {
    end.await();
  }

  @Override
  public void close() {
    end();
    bench.close();
    server.close();
  }
}
