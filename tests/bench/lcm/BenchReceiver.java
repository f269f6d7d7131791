import java.util.Locale;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmStatistics;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.SubscriptionOptions;

/**
 * Counts messages with our client and says at each END what came since the last one, and what the client counted as
 * lost.
 */
public final class BenchReceiver {
  private long messages;
  private long bytes;
  private long first;
  private long last;
  private long lost;
  private byte told;
  private final Lcm lcm;

  private BenchReceiver(Lcm lcm) {
    this.lcm = lcm;
  }

  public static void main(String[] arguments) throws InterruptedException {
    Lcm lcm = Lcm.open(LcmUrl.of(arguments[0]), LcmOptions.standard(Thread.ofPlatform().factory()));
    BenchReceiver counts = new BenchReceiver(lcm);
    lcm.subscribe("DATA", SubscriptionOptions.direct(), message -> counts.data(message.data().remaining()));
    lcm.subscribe("END", SubscriptionOptions.direct(), message -> counts.end(message.data().get()));
    while (!(lcm.state() instanceof LcmState.Connected)) {
      Thread.sleep(1);
    }
    System.out.println("\"ready\"");
  }

  private void data(int size) {
    last = System.nanoTime();
    if (messages++ == 0) {
      first = last;
    }
    bytes += size;
  }

  private void end(byte flood) {
    if (flood != told) {
      told = flood;
      LcmStatistics statistics = lcm.statistics();
      long before = lost;
      lost = statistics.lost() + statistics.incomplete();
      System.out.printf(Locale.ROOT, "{\"messages\": %d, \"bytes\": %d, \"seconds\": %.9f, \"counted\": %d}%n",
          messages, bytes,
          (last - first) / 1e9, lost - before);
      messages = 0;
      bytes = 0;
      first = 0;
      last = 0;
    }
  }
}
