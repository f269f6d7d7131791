package org.robotui.gl.internal.context;

import com.jogamp.nativewindow.NativeWindowException;
import com.jogamp.nativewindow.NativeWindowFactory;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLContext;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLOffscreenAutoDrawable;
import com.jogamp.opengl.GLProfile;
import org.robotui.gl.internal.gpu.Gpu;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A context of OpenGL without a window, current on the thread that opened it until it is closed there. */
final class GlContext implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(GlContext.class);
  private static final String DISPLAY = "DISPLAY";
  private static final String SESSION =
      "Start it in a desktop session (under Wayland with the package xwayland), or under xvfb-run.";
  private static final String PACKAGES =
      "Install the packages libgl1 and libgl1-mesa-dri, which draw by the processor where there is no graphics card.";
  /** The old functions beside the new ones: software draws points two to three times faster with them. */
  private static final String[] PROFILES = {GLProfile.GL4bc, GLProfile.GL3bc, GLProfile.GL4, GLProfile.GL3};
  private static final int TINY = 16;

  private final GLOffscreenAutoDrawable drawable;
  private final Gpu gpu;

  private GlContext(GLOffscreenAutoDrawable drawable) {
    this.drawable = drawable;
    gpu = new Gpu(drawable.getGL().getGL3());
  }

  /** Opens one, or says why there is none. */
  static GlContext open() throws NoOpenGl {
    requireDisplay();
    try {
      return made();
    } catch (LinkageError e) {
      LOG.debug("OpenGL cannot be loaded", e);
      throw new NoOpenGl("The libraries of OpenGL cannot be loaded: " + e.getMessage() + ".", PACKAGES);
    } catch (NativeWindowException e) {
      LOG.debug("No display for OpenGL", e);
      throw new NoOpenGl("The X display " + System.getenv(DISPLAY) + " does not open for OpenGL.", SESSION);
    } catch (RuntimeException e) {
      LOG.debug("No context of OpenGL", e);
      throw new NoOpenGl("OpenGL does not start: " + words(e) + ".", PACKAGES);
    }
  }

  /** Without the device, which JOGL names with the inner state of its objects. */
  private static String words(RuntimeException failure) {
    return String.valueOf(failure.getMessage()).split(" on device ", 2)[0];
  }

  /** Without a display JOGL fails late, and prints. */
  private static void requireDisplay() throws NoOpenGl {
    String display = System.getenv(DISPLAY);
    if (display == null || display.isBlank()) {
      throw new NoOpenGl("There is no X display for OpenGL: DISPLAY is not set.", SESSION);
    }
  }

  private static GlContext made() throws NoOpenGl {
    GLProfile profile = GLProfile.get(PROFILES, true);
    if (profile == null) {
      throw new NoOpenGl("This machine has no OpenGL 3.3.", PACKAGES);
    }
    GLCapabilities wanted = new GLCapabilities(profile);
    wanted.setOnscreen(false);
    wanted.setDoubleBuffered(false);
    GLDrawableFactory factory = GLDrawableFactory.getFactory(profile);
    GLOffscreenAutoDrawable drawable = factory.createOffscreenAutoDrawable(null, wanted, null, TINY, TINY);
    drawable.display();
    if (drawable.getContext().makeCurrent() == GLContext.CONTEXT_NOT_CURRENT) {
      drawable.destroy();
      throw new GLException("the context cannot be made current");
    }
    return new GlContext(drawable);
  }

  /**
   * Has something run at the end of the virtual machine, before JOGL takes away the displays. Its own hook for that
   * runs beside all others, so that contexts which are closed by another one come too late: it ends the connection of a
   * picture in work, and prints what it found open.
   */
  static void beforeTheEnd(Runnable action) {
    NativeWindowFactory.addCustomShutdownHook(true, action);
  }

  Gpu gpu() {
    return gpu;
  }

  @Override
  public void close() {
    try {
      drawable.getContext().release();
      drawable.destroy();
    } catch (RuntimeException e) {
      LOG.debug("A context that failed before cannot be closed", e);
    }
  }
}
