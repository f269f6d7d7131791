package org.robotui.ui.internal;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Pattern;

/**
 * How the toolkit enlarges and continues a pattern made of an image. It is not part of what SWT promises, so it is
 * looked up, as {@link SurfacePixels} is. Display thread.
 */
public final class PatternLook {
  private static final String CAIRO = "org.eclipse.swt.internal.cairo.Cairo";
  private static final int FAST = 0;
  private static final int GOOD = 1;
  private static final int BEST = 2;
  private static final int NEAREST = 3;
  /** Beyond its edges, the pattern goes on as it is at the edge. */
  private static final int PAD = 3;

  private final MethodHandle handle;
  private final MethodHandle filter;
  private final MethodHandle extend;

  private PatternLook() throws ReflectiveOperationException {
    MethodHandles.Lookup lookup = MethodHandles.publicLookup();
    Class<?> cairo = Pattern.class.getClassLoader().loadClass(CAIRO);
    MethodType setter = MethodType.methodType(void.class, long.class, int.class);
    handle = lookup.findGetter(Pattern.class, "handle", long.class);
    filter = lookup.findStatic(cairo, "cairo_pattern_set_filter", setter);
    extend = lookup.findStatic(cairo, "cairo_pattern_set_extend", setter);
  }

  /**
   * Looks for it.
   *
   * @return none where the toolkit has other patterns
   */
  public static Optional<PatternLook> find() {
    try {
      return Optional.of(new PatternLook());
    } catch (ReflectiveOperationException | LinkageError e) {
      return Optional.empty();
    }
  }

  /**
   * Has a pattern look as an image that is drawn does.
   *
   * @param pattern made of an image
   * @param interpolation of {@link SWT}, as for the image
   */
  public void asImage(Pattern pattern, int interpolation) {
    int kind = switch (interpolation) {
      case SWT.NONE -> NEAREST;
      case SWT.LOW -> FAST;
      case SWT.HIGH -> BEST;
      default -> GOOD;
    };
    try {
      long there = (long) handle.invokeExact(pattern);
      filter.invokeExact(there, kind);
      extend.invokeExact(there, PAD);
    } catch (Throwable e) {
      throw Unexpected.of(e);
    }
  }
}
