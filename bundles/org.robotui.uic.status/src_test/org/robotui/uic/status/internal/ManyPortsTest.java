package org.robotui.uic.status.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.AbstractList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.PortStatus;
import org.robotui.testkit.FakeUicContext;

/**
 * What a tick has to do for a robot of thousands of ports, counted: how long that takes is another matter on every
 * machine.
 */
class ManyPortsTest {
  private static final int PORTS = 2000;
  private static final int LOOKS_AT_EACH = 10;
  private static final long BYTES_OF_EACH = 200;

  private final FakeUicContext context = new FakeUicContext("status", new StatusType().schema());
  private final StatusUic uic = new StatusUic(context);

  /** Ports that count how often they are looked at. */
  private static final class Counted extends AbstractList<PortStatus> {
    private final List<PortStatus> ports;
    private int looks;

    Counted(List<PortStatus> ports) {
      this.ports = ports;
    }

    @Override
    public PortStatus get(int index) {
      looks++;
      return ports.get(index);
    }

    @Override
    public int size() {
      return ports.size();
    }
  }

  @Test
  void aTickLooksAtEachPortAFewTimes() {
    for (int age = 0; age < 3; age++) {
      Counted ports = show(PORTS, age);
      assertTrue(uic.tick(age));
      assertTrue(ports.looks <= LOOKS_AT_EACH * PORTS, ports.looks + " looks");
    }
  }

  @Test
  void aTickWithoutNewsMakesNoLines() {
    show(PORTS, 1);
    assertTrue(uic.tick(0));
    Page before = uic.page();
    Counted same = show(PORTS, 1);
    assertFalse(uic.tick(1));
    assertTrue(same.looks <= PORTS, same.looks + " looks");
    assertEquals(before, uic.page());
  }

  @Test
  void aTickMakesNoWordsOfWhatIsNotSeen() {
    assertWordless("");
  }

  @Test
  void aFilterMakesNoWordsEither() {
    assertWordless("no port is called so");
  }

  private void assertWordless(String filter) {
    uic.new Actions().filter(filter);
    show(PORTS, 1);
    uic.tick(0);
    show(PORTS, 2);
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();
    assertTrue(uic.tick(1) || !filter.isEmpty());
    long taken = threads.getCurrentThreadAllocatedBytes() - before;
    assertTrue(taken < BYTES_OF_EACH * PORTS, taken + " bytes for " + PORTS + " ports");
  }

  /** A robot of which a tenth of the ports is used and tells an age. */
  private Counted show(int many, int age) {
    Counted ports = new Counted(IntStream.range(0, many).mapToObj(i -> port(i, age)).toList());
    context.ruic().snapshot(Snapshots.of(Snapshots.UP, ports, List.of()));
    return ports;
  }

  private static PortStatus port(int i, int age) {
    boolean used = i % 10 == 0;
    return Snapshots.port("/node_%04d/topic".formatted(i), "LaserScan", used, used ? 10 : 0,
        used ? age * 0.1 : Double.NaN, false, 0, "");
  }
}
