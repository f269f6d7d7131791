import com.sun.management.OperatingSystemMXBean;
import com.sun.management.ThreadMXBean;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;

/** What came in while it was measured: from the first message of that phase to the one that ends it. */
final class Tally {

  private static final VarHandle LONG = MethodHandles.byteBufferViewVarHandle(long[].class, ByteOrder.nativeOrder());
  private static final OperatingSystemMXBean SYSTEM =
      (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private final ByteBuffer credit;
  private final CountDownLatch done = new CountDownLatch(1);
  private final long[] latencies = new long[1 << 20];
  private long count;
  private long first;
  private long expected;
  private long nanos;
  private long cpuNanos;
  private long allocated;

  Tally(ByteBuffer credit) {
    this.credit = credit;
  }

  void add(String tag) {
    long time = System.nanoTime();
    long number = hex(tag, 1);
    char phase = tag.charAt(0);
    if (phase == 'm') {
      measured(tag, number, time);
    } else if (phase == 'e') {
      finish(number, time);
    }
    LONG.setRelease(credit, 0, number + 1);
    if (phase == 'e') {
      done.countDown();
    }
  }

  private void measured(String tag, long number, long time) {
    if (count == 0) {
      first = number;
      nanos = -time;
      cpuNanos = -SYSTEM.getProcessCpuTime();
      allocated = -THREADS.getCurrentThreadAllocatedBytes();
    }
    if (count < latencies.length) {
      latencies[(int) count] = time - hex(tag, 17);
    }
    count++;
  }

  private void finish(long number, long time) {
    allocated += THREADS.getCurrentThreadAllocatedBytes();
    cpuNanos += SYSTEM.getProcessCpuTime();
    nanos += time;
    expected = number - first;
  }

  private static long hex(String tag, int from) {
    long value = 0;
    for (int i = from; i < from + 16; i++) {
      value = value << 4 | Character.digit(tag.charAt(i), 16);
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
