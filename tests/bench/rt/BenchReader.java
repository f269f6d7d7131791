import com.sun.management.ThreadMXBean;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.locks.LockSupport;
import org.robotui.xbot.RtClient;

/**
 * Reads the state of a running control as the workbench does: attached by JNI, decoded out of the shared memory. Each
 * line on stdin says what and for how many seconds, and is answered by one of JSON; times are microseconds.
 */
final class BenchReader {
  private static final double SECOND = 1e9;
  private static final double MICRO = 1e3;
  private static final int BATCH = 100;
  private static final long SHORTEST = 2_000_000; // between two looks, ns
  private static final long LONGEST = 4_000_000;

  private final RtClient robot;
  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private BenchReader(RtClient robot) {
    this.robot = robot;
  }

  public static void main(String[] arguments) throws IOException {
    try (RtClient robot = RtClient.connect(arguments[0])) {
      BenchReader bench = new BenchReader(robot);
      BufferedReader lines = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        String[] words = line.split(" ");
        System.out.println(bench.answer(words[0], System.nanoTime() + (long) (Double.parseDouble(words[1]) * SECOND)));
      }
    }
  }

  private String answer(String what, long end) {
    return switch (what) {
      case "read" -> read(end);
      case "follow" -> ages(follow(end));
      case "look" -> ages(look(end));
      default -> "error there is no measurement " + what;
    };
  }

  /** As often as it goes. */
  private String read(long end) {
    long before = threads.getCurrentThreadAllocatedBytes();
    long begin = System.nanoTime();
    long reads = 0;
    long seen = 0;
    while (System.nanoTime() < end) {
      for (int i = 0; i < BATCH; i++) {
        seen += robot.state().orElseThrow().joints().size();
      }
      reads += BATCH;
    }
    if (seen == 0) {
      return "error the robot has no joints";
    }
    double each = (System.nanoTime() - begin) / MICRO / reads;
    return String.format(Locale.ROOT, "{\"read\": %.4f, \"allocated\": %.1f}", each,
        (threads.getCurrentThreadAllocatedBytes() - before) / (double) reads);
  }

  /** Every cycle, as soon as it is there. */
  private long[] follow(long end) {
    Ages ages = new Ages();
    for (long last = robot.newestCycle(); System.nanoTime() < end; last = robot.newestCycle()) {
      while (robot.newestCycle() == last && System.nanoTime() < end) {
        Thread.onSpinWait();
      }
      ages.add(age());
    }
    return ages.sorted();
  }

  /** Now and then, at no particular point of a cycle. */
  private long[] look(long end) {
    Ages ages = new Ages();
    while (System.nanoTime() < end) {
      LockSupport.parkNanos(ThreadLocalRandom.current().nextLong(SHORTEST, LONGEST));
      ages.add(age());
    }
    return ages.sorted();
  }

  /** Both clocks are that of the machine. */
  private long age() {
    long sensed = robot.state().orElseThrow().sensedNanos();
    return System.nanoTime() - sensed;
  }

  private static String ages(long[] sorted) {
    return String.format(Locale.ROOT, "{\"p50\": %.2f, \"p99\": %.2f, \"count\": %d}",
        sorted[sorted.length / 2] / MICRO,
        sorted[sorted.length * 99 / 100] / MICRO, sorted.length);
  }

  private static final class Ages {
    private long[] all = new long[1024];
    private int count;

    void add(long age) {
      if (count == all.length) {
        all = Arrays.copyOf(all, 2 * count);
      }
      all[count++] = age;
    }

    long[] sorted() {
      long[] sorted = Arrays.copyOf(all, count);
      Arrays.sort(sorted);
      return sorted;
    }
  }
}
