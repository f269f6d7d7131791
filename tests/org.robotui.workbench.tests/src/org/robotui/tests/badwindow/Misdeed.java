package org.robotui.tests.badwindow;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;

/** What foreign code may do wrong on the display thread. */
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
  /** More memory than there is. */
  HOARD {
    @Override
    void commit() {
      List<long[]> hoard = new ArrayList<>();
      while (hoard.size() < Integer.MAX_VALUE) {
        hoard.add(new long[Integer.MAX_VALUE / 2]);
      }
    }
  },
  /** Nothing for longer than a busy machine takes to see it. */
  BLOCK_3 {
    @Override
    void commit() {
      block(3);
    }
  },
  /** More than anybody waits. */
  BLOCK_15 {
    @Override
    void commit() {
      block(15);
    }
  };

  abstract void commit();

  private static void block(long seconds) {
    long end = System.nanoTime() + seconds * 1_000_000_000L;
    while (System.nanoTime() < end) {
      LockSupport.parkNanos(end - System.nanoTime());
    }
  }
}
