package org.robotui.ui.internal;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.SWTException;
import org.eclipse.swt.graphics.Image;

/**
 * The memory in which the toolkit keeps the pixels of an image. It is not part of what SWT promises, so it is looked
 * up, and whoever wants it goes the long way where there is none: on another platform or in another version.
 */
public final class SurfacePixels {
  private static final String TOOLKIT = "org.eclipse.swt.internal.";
  private static final int BYTES = 4;

  private final MethodHandle surface;
  private final MethodHandle data;
  private final MethodHandle stride;
  private final MethodHandle height;
  private final MethodHandle move;
  private final MethodHandle changed;

  private SurfacePixels() throws ReflectiveOperationException {
    MethodHandles.Lookup lookup = MethodHandles.publicLookup();
    Class<?> cairo = Image.class.getClassLoader().loadClass(TOOLKIT + "cairo.Cairo");
    Class<?> memory = Image.class.getClassLoader().loadClass(TOOLKIT + "C");
    surface = lookup.findGetter(Image.class, "surface", long.class);
    data = lookup.findStatic(cairo, "cairo_image_surface_get_data", MethodType.methodType(long.class, long.class));
    stride = lookup.findStatic(cairo, "cairo_image_surface_get_stride", MethodType.methodType(int.class, long.class));
    height = lookup.findStatic(cairo, "cairo_image_surface_get_height", MethodType.methodType(int.class, long.class));
    move = lookup.findStatic(memory, "memmove", MethodType.methodType(void.class, long.class, int[].class, long.class));
    changed = lookup.findStatic(cairo, "cairo_surface_mark_dirty", MethodType.methodType(void.class, long.class));
  }

  /**
   * Looks for it.
   *
   * @return none where the toolkit keeps pixels otherwise
   */
  public static Optional<SurfacePixels> find() {
    try {
      return Optional.of(new SurfacePixels());
    } catch (ReflectiveOperationException | LinkageError e) {
      return Optional.empty();
    }
  }

  /**
   * Whether an image lies there as rows of words of four bytes, one after the other.
   *
   * @param image without transparency
   * @param pixels a row
   * @param rows how many
   * @return false where it is kept otherwise, for example by the display's server
   */
  public boolean has(Image image, int pixels, int rows) {
    try {
      long there = (long) surface.invokeExact(image);
      return there != 0 && (long) data.invokeExact(there) != 0
          && (int) stride.invokeExact(there) == BYTES * pixels && (int) height.invokeExact(there) == rows;
    } catch (Throwable e) {
      throw Unexpected.of(e);
    }
  }

  /**
   * Replaces the pixels. Any thread, while nobody paints the image.
   *
   * @param image one that {@link #has} this size
   * @param rgb at least as many as it has
   * @param count how many it has
   */
  public void write(Image image, int[] rgb, int count) {
    try {
      long there = (long) surface.invokeExact(image);
      if (there == 0) {
        throw new SWTException(SWT.ERROR_GRAPHIC_DISPOSED);
      }
      move.invokeExact((long) data.invokeExact(there), rgb, (long) BYTES * count);
    } catch (Throwable e) {
      throw Unexpected.of(e);
    }
  }

  /**
   * Has what the toolkit derived from the former pixels forgotten. Display thread.
   *
   * @param image that was or will be written
   */
  public void forget(Image image) {
    try {
      changed.invokeExact((long) surface.invokeExact(image));
    } catch (Throwable e) {
      throw Unexpected.of(e);
    }
  }
}
