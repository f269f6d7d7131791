package org.robotui.tests.bad;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;

/** What foreign code may do wrong. What goes on without end ends when the property says that the test is over. */
enum Misdeed {
  /** None. */
  NOTHING {
    @Override
    void commit() {}
  },
  /** An exception. */
  THROW {
    @Override
    void commit() {
      throw new IllegalStateException("a bug");
    }
  },
  /** An exception whose message throws. */
  THROW_HOSTILE {
    @Override
    void commit() {
      throw new HostileException();
    }
  },
  /** An assertion that does not hold. */
  ASSERT {
    @Override
    void commit() {
      throw new AssertionError("an invariant");
    }
  },
  /** A recursion without end. */
  OVERFLOW {
    @Override
    void commit() {
      commit();
    }
  },
  /** A class that is not there. */
  NO_CLASS {
    @Override
    void commit() {
      throw new NoClassDefFoundError("org/robotui/gone/Library");
    }
  },
  /** A lock that never comes, until it is interrupted. */
  WAIT {
    @Override
    void commit() {
      while (!isOver() && !Thread.currentThread().isInterrupted()) {
        LockSupport.parkNanos(STEP_NANOS);
      }
    }
  },
  /** The same, deaf to interrupts. */
  WAIT_DEAF {
    @Override
    void commit() {
      while (!isOver()) {
        LockSupport.parkNanos(STEP_NANOS);
        Thread.interrupted();
      }
    }
  },
  /** A loop without end. */
  SPIN {
    @Override
    void commit() {
      while (!isOver()) {
        Thread.onSpinWait();
      }
    }
  },
  /** Half a second of nothing. */
  DELAY {
    @Override
    void commit() {
      LockSupport.parkNanos(500_000_000L);
    }
  },
  /** A thread beside the factory, that no interrupt ends. */
  LEAK {
    @Override
    void commit() {
      Thread thread = new Thread(WAIT_DEAF::commit, "leaked-" + System.nanoTime());
      thread.setDaemon(true);
      thread.start();
    }
  },
  /** A thread beside the factory, that an interrupt ends. */
  LEAK_POLITE {
    @Override
    void commit() {
      Thread thread = new Thread(WAIT::commit, "leaked-" + System.nanoTime());
      thread.setDaemon(true);
      thread.start();
    }
  },
  /** A thread beside the factory that throws. */
  LEAK_THROWING {
    @Override
    void commit() {
      new Thread(THROW::commit, "leaked-" + System.nanoTime()).start();
    }
  },
  /** All memory there is, held for ever. */
  HOARD {
    @Override
    void commit() {
      List<byte[]> hoard = new ArrayList<>();
      while (!isOver()) {
        hoard.add(new byte[CHUNK]);
      }
    }
  },
  /**
   * So much memory that robots are stopped, held for ever, and more as soon as there is some again. What is left is
   * enough to stop them: of memory that is used up to the last byte, faster than anybody looks, nothing is promised.
   */
  HOARD_FOR_EVER {
    @Override
    void commit() {
      hoard(0.97);
    }
  },
  /** Nearly all memory there is, held for ever. */
  HOARD_MOST {
    @Override
    void commit() {
      hoard(0.87);
    }
  };

  /** Set to {@code true} where all shall end. */
  static final String OVER = "robotui.tests.over";

  private static final long STEP_NANOS = 1_000_000;
  private static final int CHUNK = 256 * 1024;

  abstract void commit();

  /** Holds a share of the old part of the heap. */
  private static void hoard(double share) {
    MemoryPoolMXBean old = ManagementFactory.getMemoryPoolMXBeans().stream()
        .filter(pool -> pool.getType() == MemoryType.HEAP && pool.isUsageThresholdSupported()).findFirst()
        .orElseThrow();
    List<byte[]> hoard = new ArrayList<>();
    while (!isOver()) {
      if (old.getUsage().getUsed() < share * old.getUsage().getMax()) {
        hoard.add(new byte[CHUNK]);
      }
      System.gc();
      LockSupport.parkNanos(STEP_NANOS);
    }
  }

  private static boolean isOver() {
    return Boolean.getBoolean(OVER);
  }
}
