package org.robotui.rfic.yarp.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.data.Data;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.sensor.LaserScan;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.testkit.rfic.Peer;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.wire.MjpegFraming;

/** Streams by the carriers that users ask for. */
@Timeout(120)
class CarriersTest {
  private static final Bottle SCAN = Bottle.of(0.0, 90.0, 0.1, 8.0, List.of(1.0, 2.0), 1);
  private static final String LASER = "/robby/laser";

  private final YarpRobot robot;

  CarriersTest() throws IOException {
    robot = new YarpRobot();
    robot.says(LASER);
  }

  @AfterEach
  void end() {
    robot.close();
  }

  @ParameterizedTest
  @ValueSource(strings = {"udp", "mcast"})
  void datagrams_come_while_somebody_looks_and_from_a_port_that_was_started_anew(String carrier) throws IOException {
    robot.look(Map.of("prefix", "/robby", "carriers", Map.of(LASER, carrier)));
    robot.next("laser", LaserScan.class, LASER, SCAN);
    robot.context.demand("laser", false);
    robot.await("it says nothing more", () -> robot.ports.get(LASER).targets().isEmpty());
    robot.next("laser", LaserScan.class, LASER, SCAN);
    robot.end(LASER);
    robot.says(LASER);
    robot.next("laser", LaserScan.class, LASER, SCAN);
  }

  @Test
  void pictures_are_fetched_as_jpeg_files() throws IOException {
    byte[] jpeg = {-1, (byte) 0xd8, -1, (byte) 0xd9};
    Workers workers = new Workers(Peer.THREADS);
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      workers.start("camera", () -> show(server, jpeg));
      robot.server().register("/robby/cam", new HostPort("127.0.0.1", server.getLocalPort()));
      robot.look(Map.of("carrier", "mjpeg", "prefix", "/robby"));
      robot.await("it is offered", () -> robot.context.streams.containsKey("cam"));
      robot.context.demand("cam", true);
      robot.await("a picture", () -> !robot.context.published.get("cam").isEmpty());
      Data data = robot.context.published.get("cam").getLast().value();
      assertEquals(List.of("jpeg", 4),
          List.of(((CompressedImage) data).format(), ((CompressedImage) data).data().size()));
      robot.next("laser", LaserScan.class, LASER, SCAN);
    }
  }

  /** Whoever does not ask for pictures is let go. */
  private static void show(ServerSocket server, byte[] jpeg) {
    byte[] request = MjpegFraming.request("127.0.0.1");
    while (!server.isClosed()) {
      try (Socket socket = server.accept()) {
        byte[] asked = socket.getInputStream().readNBytes(request.length);
        if (Arrays.equals(asked, request)) {
          socket.getOutputStream().write(MjpegFraming.answer());
          socket.getOutputStream().write(MjpegFraming.part(jpeg));
          socket.getInputStream().read();
        }
      } catch (IOException e) {
        // the next one
      }
    }
  }
}
