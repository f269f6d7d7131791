package org.robotui.gl.internal.draw;

import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Shape;
import org.robotui.gl.shape.TriangleMesh;

/** A shape on the graphics card. */
public interface Drawn {
  /**
   * Makes an empty one of the kind that a shape needs.
   *
   * @param gpu where
   * @param shape for which
   * @return one that {@link #takes(Shape) takes} it
   */
  static Drawn of(Gpu gpu, Shape shape) {
    return switch (shape) {
      case PointSet points -> gpu.limits().software() ? new SplattedPoints(gpu) : new DrawnPoints(gpu);
      case LineSet lines -> new DrawnLines(gpu);
      case TriangleMesh mesh -> new DrawnMesh(gpu);
      case Instances instances -> new DrawnInstances(gpu);
      case Label label -> new DrawnLabel(gpu);
    };
  }

  /**
   * Whether it can hold a shape.
   *
   * @param shape another one
   * @return true where the kind is the same
   */
  boolean takes(Shape shape);

  /**
   * Holds a shape in place of what it held.
   *
   * @param shape one that it takes
   * @return the bytes sent
   */
  long fill(Shape shape);

  /**
   * Whether some of its own colours are.
   *
   * @return true where what lies behind may be seen
   */
  boolean translucent();

  /**
   * Writes it into the splats of a picture, where the processor is quicker with it than OpenGL.
   *
   * @param pass the picture
   * @param look how it looks in it
   * @return false where OpenGL is to draw it
   */
  default boolean paint(Pass pass, DrawState look) {
    return false;
  }

  /**
   * Draws it by OpenGL.
   *
   * @param pass the picture
   * @param look how it looks in it
   */
  void draw(Pass pass, DrawState look);

  /**
   * What it takes.
   *
   * @return bytes
   */
  long bytes();

  /** Frees it. */
  void delete();
}
