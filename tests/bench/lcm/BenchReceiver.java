import java.util.Locale;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.SubscriptionOptions;

/** Counts messages with our client and says at each END what came since the last one. */
public final class BenchReceiver {
  private long messages;
  private long bytes;
  private long first;
  private long last;
  private byte told;

  private BenchReceiver() {}

  public static void main(String[] arguments) throws InterruptedException {
    BenchReceiver counts = new BenchReceiver();
    Lcm lcm = Lcm.open(LcmUrl.of(arguments[0]), LcmOptions.standard(Thread.ofPlatform().factory()));
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
      System.out.printf(Locale.ROOT, "{\"messages\": %d, \"bytes\": %d, \"seconds\": %.9f}%n", messages, bytes, (last - first) / 1e9);
      messages = 0;
      bytes = 0;
      first = 0;
      last = 0;
    }
  }
}
