package org.robotui.workbench.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.osgi.framework.Bundle;
import org.osgi.framework.FrameworkUtil;
import org.osgi.framework.ServiceReference;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.render.Eye;
import org.robotui.gl.render.Gl;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.render.Renderer;
import org.robotui.gl.shape.Rgba;

/** JOGL is no bundle: here it works as part of one, with the libraries that the framework unpacks. */
class GlServiceTest {
  private static final int SIDE = 8;

  @Test
  void theServiceMakesPicturesInTheFramework() throws Exception {
    Bundle own = FrameworkUtil.getBundle(getClass());
    ServiceReference<Gl> reference = Optional.ofNullable(own.getBundleContext().getServiceReference(Gl.class))
        .orElseThrow(() -> new AssertionError("there is no service of OpenGL"));
    Gl gl = own.getBundleContext().getService(reference);
    try (Renderer renderer = gl.open("test")) {
      Eye eye = new Eye(RigidTransform.IDENTITY, new Eye.Projection.Parallel(1), 1, 2);
      RenderRequest request = new RenderRequest(Map.of(), eye, SIDE, SIDE, 1, Rgba.of(0x123456), 1, List.of());
      Rendered rendered = renderer.render(request).toCompletableFuture().get(1, TimeUnit.MINUTES);
      Rendered.Picture picture = assertInstanceOf(Rendered.Picture.class, rendered, rendered::toString);
      assertEquals(0x123456, picture.rgb()[0]);
    } finally {
      own.getBundleContext().ungetService(reference);
    }
  }
}
