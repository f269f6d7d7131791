import java.io.IOException;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Scanner;
import java.util.concurrent.ThreadFactory;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.module.IpcModule;
import org.robotui.carmen.module.ModuleOptions;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.RecordCodec;
import org.robotui.message.RosValue;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.net.socket.HostPort;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.smartsoft.client.PushClient;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.wire.LinkOptions;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.port.PortOptions;
import org.robotui.yarp.port.YarpPort;

/**
 * Hears scans with our client of one framework: FRAMEWORK ADDRESS. Says where it listens itself, then for each count on
 * a line of input how long so many scans took. All ranges of each scan are looked at.
 */
public final class BenchScans {
  private static final ThreadFactory THREADS = Thread.ofPlatform().daemon().factory();
  private static final int LATEST = 1;
  private static final int RANGES = 4;

  private long left;
  private long first;
  private double sum;

  private BenchScans() {}

  public static void main(String[] arguments) throws Exception {
    BenchScans scans = new BenchScans();
    String address = arguments[1];
    int port = 0;
    switch (arguments[0]) {
      case "ros" -> scans.ros();
      case "carmen" -> scans.carmen(Integer.parseInt(address));
      case "yarp" -> port = scans.yarp();
      case "smartsoft" -> scans.smartSoft(ServiceAddress.parse(address));
      default -> throw new IllegalArgumentException("there is no client of " + arguments[0]);
    }
    System.out.println(port);
    try (Scanner orders = new Scanner(System.in)) {
      while (orders.hasNextLong()) {
        scans.await(orders.nextLong());
      }
    }
    System.exit(0);
  }

  private void ros() throws IOException {
    RosNode node = RosNode.open(RosEnvironment.of(System.getenv(), List.of()), GraphName.of("bench_robotui"),
        NodeOptions.standard(THREADS));
    node.subscriber("/scan", RecordCodec.of(LaserScan.class), SubscriberOptions.standard(), (scan, from) -> {
      double all = 0;
      for (float range : scan.ranges()) {
        all += range;
      }
      heard(all);
    });
  }

  private void carmen(int port) throws IOException {
    IpcForms forms = IpcForms.carmen();
    IpcModule module = IpcModule.connect(new HostPort("127.0.0.1", port), forms, ModuleOptions.of("bench", THREADS));
    module.subscribe(forms.get("carmen_robot_frontlaser"), LATEST, (scan, bytes) -> {
      double all = 0;
      for (float range : scan.floats("range")) {
        all += range;
      }
      heard(all);
      return Optional.empty();
    });
  }

  private int yarp() throws IOException {
    YarpPort port = new YarpPort("/bench", InetAddress.getLoopbackAddress(), 0, Optional.empty(), arrival -> {
      double all = 0;
      for (double range : ((Bottle) arrival.bottle().get(RANGES)).numbers()) {
        all += range;
      }
      heard(all);
      return Optional.empty();
    }, PortOptions.of(THREADS));
    return port.port();
  }

  private void smartSoft(ServiceAddress address) throws IOException {
    CommType type = CommTypes.shipped().get("CommBasicObjects::CommLaserScan");
    PushClient client = PushClient.connect(address, LinkOptions.of(THREADS), object -> heard(distances(type, object)));
    client.subscribe(1);
  }

  private static double distances(CommType type, ByteBuffer object) {
    try {
      double all = 0;
      DynamicMessage scan = type.read(object);
      if (scan.field("scan_points").orElseThrow() instanceof RosValue.Messages points) {
        for (DynamicMessage point : points.values()) {
          all += point.number("distance").orElseThrow();
        }
      }
      return all;
    } catch (MessageException e) {
      throw new IllegalStateException(e);
    }
  }

  private synchronized void heard(double value) {
    sum += value;
    if (first == 0) {
      first = System.nanoTime();
    }
    if (--left == 0) {
      System.out.printf(Locale.ROOT, "{\"seconds\": %.9f, \"sum\": %.6g}%n", (System.nanoTime() - first) / 1e9, sum);
      first = 0;
    }
  }

  private synchronized void await(long count) {
    left = count;
    System.out.println("\"waits\"");
  }
}
