import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Scanner;
import java.util.Set;
import java.util.StringJoiner;
import org.robotui.recording.ChunkCompression;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.RecordingWriter;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.WriterOptions;

/** Our library: reads all of a recording, goes to places in it, and copies it to MCAP. A line of JSON for each line. */
public final class BenchRecording {
  private static final double GOLDEN = 0.6180339887498949;
  /** What our recorder has to say itself. */
  private static final String OWN = "/robotui/";

  private BenchRecording() {}

  public static void main(String[] arguments) throws IOException {
    Scanner lines = new Scanner(System.in);
    while (lines.hasNextLine()) {
      String[] words = lines.nextLine().split(" ");
      System.out.println(switch (words[0]) {
        case "read" -> read(Path.of(words[1]));
        case "seek" -> seek(Path.of(words[1]), Integer.parseInt(words[2]));
        default -> copy(Path.of(words[1]), Path.of(words[2]));
      });
    }
  }

  private static double since(long begin) {
    return (System.nanoTime() - begin) * 1e-9;
  }

  private static String read(Path file) throws IOException {
    long begin = System.nanoTime();
    long messages = 0;
    long bytes = 0;
    byte[] copy = new byte[0];
    try (RecordingReader recording = Recordings.open(file, ScanProgress.NONE)) {
      RecordingCursor cursor = recording.cursor(RecordingInterval.ALWAYS, Set.of());
      for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
        ByteBuffer data = next.get().data().duplicate();
        int size = data.remaining();
        copy = copy.length < size ? new byte[size] : copy;
        data.get(copy, 0, size);
        if (!next.get().channel().topic().startsWith(OWN)) {
          messages++;
          bytes += size;
        }
      }
    }
    return "{\"seconds\":" + since(begin) + ",\"messages\":" + messages + ",\"bytes\":" + bytes + "}";
  }

  private static String seek(Path file, int times) throws IOException {
    long begin = System.nanoTime();
    try (RecordingReader recording = Recordings.open(file, ScanProgress.NONE)) {
      RecordingInterval span = recording.span().orElseThrow();
      double opened = since(begin);
      StringJoiner seeks = new StringJoiner(",", "[", "]");
      for (int i = 1; i <= times; i++) {
        long went = System.nanoTime();
        long at = span.start() + (long) ((span.end() - span.start()) * (i * GOLDEN % 1));
        recording.cursor(RecordingInterval.from(at), Set.of()).next().orElseThrow();
        seeks.add(Double.toString(since(went)));
      }
      return "{\"open\":" + opened + ",\"seeks\":" + seeks + "}";
    }
  }

  private static String copy(Path from, Path to) throws IOException {
    try (RecordingReader recording = Recordings.open(from, ScanProgress.NONE);
        RecordingWriter writer =
            RecordingWriter.create(to, WriterOptions.defaults().withCompression(ChunkCompression.NONE))) {
      Map<RecordedChannel, RecordedChannel> channels = new IdentityHashMap<>();
      RecordingCursor cursor = recording.cursor(RecordingInterval.ALWAYS, Set.of());
      for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
        RecordedMessage message = next.get();
        RecordedChannel channel = channels.computeIfAbsent(message.channel(), each -> writer.channel(each.topic(),
            each.messageEncoding(), each.schema(), each.metadata()));
        writer.write(channel, message.logTime(), message.publishTime(), 0, message.data());
      }
    }
    return "{}";
  }
}
