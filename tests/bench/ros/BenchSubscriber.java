import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;

/** Our subscriber. Reads lines "KIND TOPIC" and answers each with what it saw, as one JSON object. */
final class BenchSubscriber {

  private final RosNode node;
  private final ByteBuffer credit;

  private BenchSubscriber(RosNode node, ByteBuffer credit) {
    this.node = node;
    this.credit = credit;
  }

  public static void main(String[] arguments) throws IOException, InterruptedException {
    RosEnvironment environment = RosEnvironment.of(System.getenv(), List.of());
    NodeOptions options = NodeOptions.standard(Thread.ofPlatform().daemon().factory());
    try (RosNode node = RosNode.open(environment, GraphName.of("bench_robotui"), options);
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in))) {
      BenchSubscriber bench = new BenchSubscriber(node, map(Path.of(arguments[0])));
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        String[] words = line.split(" ");
        System.out.println(bench.measure(words[0], words[1]));
      }
    }
  }

  private static ByteBuffer map(Path file) throws IOException {
    try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
      return channel.map(FileChannel.MapMode.READ_WRITE, 0, Long.BYTES);
    }
  }

  private String measure(String kind, String topic) throws InterruptedException {
    Tally tally = new Tally(credit);
    try (Subscriber subscriber = subscribe(kind, topic, tally)) {
      tally.await();
    }
    return tally.json();
  }

  private Subscriber subscribe(String kind, String topic, Tally tally) {
    if (kind.equals("image")) {
      return node.subscriber(topic, RecordCodec.of(Image.class), SubscriberOptions.standard(),
          (m, from) -> tally.add(m.header().frameId()));
    }
    return node.subscriber(topic, RecordCodec.of(StdString.class), SubscriberOptions.standard(),
        (m, from) -> tally.add(m.data()));
  }
}
