import java.util.Locale;
import java.util.Scanner;
import org.robotui.player.client.ClientOptions;
import org.robotui.player.client.DataListener;
import org.robotui.player.client.DeviceState;
import org.robotui.player.client.LinkState;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.client.PlayerDevice;
import org.robotui.player.interfaces.Camera;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Ranger;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.DeviceId;

/**
 * Decodes data with our client: PORT INTERFACE:INDEX..., then for each count on a line of input says how long so many
 * messages took.
 */
public final class BenchClient {
  private long left;
  private long first;
  private double sum;

  private BenchClient() {}

  public static void main(String[] arguments) throws InterruptedException {
    BenchClient counts = new BenchClient();
    PlayerClient client = new PlayerClient("127.0.0.1", Integer.parseInt(arguments[0]), Layouts.standard(),
        ClientOptions.standard(Thread.ofPlatform().factory()));
    while (!(client.state() instanceof LinkState.Connected)) {
      Thread.sleep(1);
    }
    for (int i = 1; i < arguments.length; i++) {
      String[] words = arguments[i].split(":");
      PlayerDevice device = client.device(new DeviceId(Integer.parseInt(words[0]), Integer.parseInt(words[1])));
      counts.listen(device);
      while (!(device.state() instanceof DeviceState.Open)) {
        Thread.sleep(1);
      }
    }
    System.out.println("\"ready\"");
    try (Scanner orders = new Scanner(System.in)) {
      while (orders.hasNextLong()) {
        counts.await(orders.nextLong());
      }
    }
    System.exit(0);
  }

  private void listen(PlayerDevice device) {
    switch (device.id().interfaceCode()) {
      case 4 -> device.subscribe(Position2d.STATE,
          (DataListener<Position2d.State>) (value, stamp, time) -> heard(value.position().x()));
      case 6 -> device.subscribe(Laser.SCAN,
          (DataListener<Laser.Scan>) (value, stamp, time) -> heard(value.maxRange()));
      case 40 -> device.subscribe(Camera.IMAGE,
          (DataListener<Camera.Image>) (value, stamp, time) -> heard(value.width()));
      default -> device.subscribe(Ranger.RANGES, (DataListener<Ranger.Ranges>) (value, stamp, time) -> heard(stamp));
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
