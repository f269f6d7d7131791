import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;

/** What came in while it was measured: from the first message of that phase to the one that ends it. */
final class Tally {

  private static final OperatingSystemMXBean SYSTEM =
      (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  /** Of a text in CDR: its length stands before it. */
  private static final int LENGTH = 4;

  private final CountDownLatch done = new CountDownLatch(1);
  private final long[] latencies = new long[1 << 20];
  private long count;
  private long first;
  private long expected;
  private long nanos;
  private long cpuNanos;
  private long allocated;

  /** A message whose tag is a text at so many bytes. */
  void add(ByteBuffer payload, int at) {
    long time = System.nanoTime();
    int tag = payload.position() + at + LENGTH;
    byte phase = payload.get(tag);
    if (phase == 'm') {
      measured(payload, tag, time);
    } else if (phase == 'e') {
      allocated += THREADS.getCurrentThreadAllocatedBytes();
      cpuNanos += SYSTEM.getProcessCpuTime();
      nanos += time;
      expected = hex(payload, tag + 1) - first;
      done.countDown();
    }
  }

  private void measured(ByteBuffer payload, int tag, long time) {
    if (count == 0) {
      first = hex(payload, tag + 1);
      nanos = -time;
      cpuNanos = -SYSTEM.getProcessCpuTime();
      allocated = -THREADS.getCurrentThreadAllocatedBytes();
    }
    if (count < latencies.length) {
      latencies[(int) count] = time - hex(payload, tag + 17);
    }
    count++;
  }

  private static long hex(ByteBuffer payload, int from) {
    long value = 0;
    for (int i = from; i < from + 16; i++) {
      value = value << 4 | Character.digit(payload.get(i), 16);
    }
    return value;
  }

  void await() throws InterruptedException {
    done.await();
  }

  String json() {
    long[] ordered = Arrays.copyOf(latencies, (int) Math.min(count, latencies.length));
    Arrays.sort(ordered);
    return String.format(Locale.ROOT,
        "{\"count\": %d, \"lost\": %d, \"seconds\": %.9f, \"cpu\": %.6f, \"p50\": %d, \"p99\": %d, \"allocated\": %d}",
        count, expected - count, nanos / 1e9, cpuNanos / 1e9, quantile(ordered, 0.5), quantile(ordered, 0.99),
        allocated);
  }

  private static long quantile(long[] ordered, double q) {
    return ordered.length == 0 ? 0 : ordered[(int) (q * (ordered.length - 1))];
  }
}
