package org.robotui.workbench.internal.display;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Type;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.eclipse.swt.widgets.Display;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Hears of the end of the X server, or of the connection to it. Otherwise the toolkit ends the process at once, past
 * all hooks of Java, and robots are left in disorder. How to hear of it is not part of what SWT promises, so it is
 * looked up; under Wayland there is no such way.
 */
public final class DisplayLoss {
  private static final Logger LOG = LoggerFactory.getLogger(DisplayLoss.class);
  private static final String TOOLKIT = "org.eclipse.swt.internal.";

  private static final int RENEW_MILLIS = 250;

  private final Runnable farewell;
  private final MethodHandle call;
  private final MethodHandle set;
  private final AtomicBoolean heard = new AtomicBoolean();
  private volatile long toolkitsOwn;

  private DisplayLoss(Runnable farewell, MethodHandle call, MethodHandle set) {
    this.farewell = farewell;
    this.call = call;
    this.set = set;
  }

  /**
   * Watches the display, which has been made before: making it sets the toolkit's own way, which ends the process and
   * goes on to do so.
   *
   * @param display on whose thread this is called
   * @param farewell is run before, once, on the thread that met the loss. It may hold locks of the toolkit, so nothing
   * of the toolkit may be used
   */
  public static void watch(Display display, Runnable farewell) {
    try {
      install(display, farewell);
    } catch (Throwable e) { // what method handles throw
      LOG.warn("if the X server ends, robots will not be left in order: this toolkit has no way to hear of it", e);
    }
  }

  private static void install(Display display, Runnable farewell) throws Throwable {
    ClassLoader loader = Display.class.getClassLoader();
    Class<?> gtk = loader.loadClass(TOOLKIT + "gtk.OS");
    Class<?> callback = loader.loadClass(TOOLKIT + "Callback");
    MethodHandles.Lookup lookup = MethodHandles.publicLookup();
    if ((boolean) lookup.findStatic(gtk, "isX11", MethodType.methodType(boolean.class)).invoke()) {
      DisplayLoss loss = new DisplayLoss(farewell,
          lookup.findStatic(gtk, "Call", MethodType.methodType(int.class, long.class, long.class, long.class)),
          lookup.findStatic(gtk, "XSetIOErrorHandler", MethodType.methodType(long.class, long.class)));
      Object entry = lookup
          .findConstructor(callback,
              MethodType.methodType(void.class, Object.class, String.class, Type.class, Type[].class))
          .invoke((Object) loss, "lost", (Type) long.class, new Type[]{long.class});
      long address =
          (long) lookup.findVirtual(callback, "getAddress", MethodType.methodType(long.class)).invoke(entry);
      loss.toolkitsOwn = (long) loss.set.invokeExact(address);
      loss.renew(display, address);
    }
  }

  /**
   * JOGL sets a handler of its own when it draws first, which aborts the process. There is no word of it, so ours is
   * set again and again.
   */
  private void renew(Display display, long address) {
    try {
      if ((long) set.invokeExact(address) != address) {
        LOG.info("another library had set its own handler for the end of the display; ours is set again");
      }
      display.timerExec(RENEW_MILLIS, () -> renew(display, address));
    } catch (Throwable e) { // what method handles throw
      LOG.warn("if the X server ends, robots will not be left in order", e);
    }
  }

  /**
   * Called by Xlib, by its name; it must not return. The process is ended by the toolkit's way, which asks nobody: the
   * end of Java's or C's would wait for locks of the connection, which this thread holds.
   */
  long lost(long connection) throws Throwable {
    if (heard.compareAndSet(false, true)) {
      try {
        farewell.run();
      } finally {
        int never = (int) call.invokeExact(toolkitsOwn, connection, 0L);
        LOG.error("the toolkit did not end the process, but answered {}", never);
      }
    }
    while (true) {
      LockSupport.park(this); // another thread met the loss as well
    }
  }
}
