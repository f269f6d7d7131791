import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.ByteBuffer;
import java.util.Locale;
import org.robotui.rtps.Participant;
import org.robotui.rtps.ParticipantSettings;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reader;

/**
 * Our reader, told as subscriber.c is: reads lines "KIND TOPIC" and answers each with what it saw, as a JSON object.
 */
final class BenchReader {

  private static final String STRING = "std_msgs::msg::dds_::String_";
  private static final String IMAGE = "sensor_msgs::msg::dds_::Image_";

  private final ParticipantSettings settings;

  private BenchReader(int domain) {
    this.settings = ParticipantSettings.standard(domain, "bench");
  }

  public static void main(String[] arguments) throws IOException, InterruptedException {
    BenchReader bench = new BenchReader(Integer.parseInt(arguments[0]));
    try (BufferedReader in = new BufferedReader(new InputStreamReader(System.in))) {
      String line = in.readLine();
      while (line != null) {
        line = line.startsWith("discover") ? bench.discover(line, in) : bench.measure(line, in);
      }
    }
  }

  private Participant open() throws IOException {
    return Participant.open(settings, Thread.ofPlatform().daemon().factory());
  }

  /** One participant for all that is measured until something else is asked for. */
  private String measure(String first, BufferedReader in) throws IOException, InterruptedException {
    try (Participant participant = open()) {
      String line = first;
      for (; line != null && !line.startsWith("discover"); line = in.readLine()) {
        String[] words = line.split(" ");
        System.out.println(measure(participant, words[0].equals("image"), words[1]));
      }
      return line;
    }
  }

  private static String measure(Participant participant, boolean image, String topic) throws InterruptedException {
    Tally tally = new Tally();
    Reader reader = participant.reader(topic, image ? IMAGE : STRING, Qos.reliable(1000), ByteBuffer.allocate(0),
        image ? sample -> tally.add(sample.payload(), 4 + 8) : sample -> tally.add(sample.payload(), 4));
    tally.await();
    reader.close();
    return tally.json();
  }

  private String discover(String line, BufferedReader in) throws IOException, InterruptedException {
    int wanted = Integer.parseInt(line.split(" ")[1]);
    long start = System.nanoTime();
    try (Participant participant = open()) {
      while (participant.discovery().endpoints().stream().filter(it -> it.topic().startsWith("rt/endpoint_"))
          .count() < wanted) {
        Thread.sleep(0, 500_000);
      }
      System.out.println(String.format(Locale.ROOT, "{\"seconds\": %.6f}", (System.nanoTime() - start) / 1e9));
    }
    return in.readLine();
  }
}
