package org.robotui.gl.internal;

import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Deactivate;
import org.robotui.gl.render.Gl;
import org.robotui.gl.render.OpenGl;
import org.robotui.gl.render.Renderer;

/** The graphics as a service, as long as the bundle runs. */
@Component(service = Gl.class)
public final class GlService implements Gl {
  private final OpenGl gl;

  /** Starts nothing yet. */
  @Activate
  public GlService() {
    // JOGL would look for its libraries beside its jars, where the framework has none; it finds them as those of this
    // bundle.
    System.setProperty("jogamp.gluegen.UseTempJarCache", "false");
    gl = new OpenGl();
  }

  @Override
  public Renderer open(String name) {
    return gl.open(name);
  }

  /** Ends the thread of OpenGL. */
  @Deactivate
  void stop() {
    gl.close();
  }
}
