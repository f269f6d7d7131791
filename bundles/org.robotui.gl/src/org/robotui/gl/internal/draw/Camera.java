package org.robotui.gl.internal.draw;

import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.gl.render.Eye.Projection;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.shape.Box3;

/**
 * From where a picture is seen. Pictures stand on their heads in OpenGL, so that rows are read from the top.
 *
 * @param eyeFromFixed x ahead, y to the left, z up
 * @param clipFromEye the projection
 * @param width pixels of the whole picture
 * @param height rows of the whole picture
 * @param scale pixels a point
 * @param perspective whether far things are smaller
 * @param seenWidth pixels of the part of the picture that is drawn
 * @param seenHeight rows of it
 * @param reach pixels that a metre takes at a distance of one, or at any where it is no perspective
 */
public record Camera(
    RigidTransform eyeFromFixed,
    Matrix clipFromEye,
    int width,
    int height,
    int seenWidth,
    int seenHeight,
    float scale,
    boolean perspective,
    double reach) {
  /**
   * The camera of a whole picture.
   *
   * @param request of the picture
   * @return the camera
   */
  public static Camera of(RenderRequest request) {
    Eye eye = request.eye();
    double aspect = (double) request.width() / request.height();
    double near = eye.near();
    double far = eye.far();
    double depth = far - near;
    RigidTransform eyeFromFixed = eye.fixedFromEye().inverse();
    return switch (eye.projection()) {
      case Projection.Perspective(double angle) -> {
        double f = 1 / Math.tan(angle / 2);
        yield camera(request, eyeFromFixed, true, f * request.height() / 2, new double[]{
            0, 0, (far + near) / depth, 1, -f / aspect, 0, 0, 0, 0, -f, 0, 0, 0, 0, -2 * far * near / depth, 0});
      }
      case Projection.Parallel(double high) -> camera(request, eyeFromFixed, false, request.height() / high,
          new double[]{
              0, 0, 2 / depth, 0, -2 / (high * aspect), 0, 0, 0, 0, -2 / high, 0, 0, 0, 0, -(far + near) / depth, 1});
    };
  }

  private static Camera camera(RenderRequest request, RigidTransform eyeFromFixed, boolean perspective, double reach,
      double[] columns) {
    int width = request.width();
    int height = request.height();
    return new Camera(eyeFromFixed, new Matrix(columns), width, height, width, height, request.scale(), perspective,
        reach);
  }

  /**
   * The same camera, of which only some pixels are seen.
   *
   * @param x of the middle, pixels from the left
   * @param y of the middle, pixels from the top
   * @param side pixels of the square that is seen
   * @return the narrower camera
   */
  public Camera around(int x, int y, int side) {
    double alongX = (double) width / side;
    double alongY = (double) height / side;
    double middleX = (2 * x + 1.0) / width - 1;
    double middleY = (2 * y + 1.0) / height - 1;
    Matrix closer = new Matrix(
        new double[]{alongX, 0, 0, 0, 0, alongY, 0, 0, 0, 0, 1, 0, -middleX * alongX, -middleY * alongY, 0, 1});
    return new Camera(eyeFromFixed, closer.times(clipFromEye), width, height, side, side, scale, perspective, reach);
  }

  /**
   * Whether something may be seen.
   *
   * @param box where it lies, in the fixed frame
   * @return false where it is outside for sure
   */
  public boolean sees(Box3 box) {
    Matrix clipFromFixed = clipFromEye.times(Matrix.of(eyeFromFixed));
    int outside = 0b111111;
    for (int corner = 0; corner < 8 && outside != 0; corner++) {
      outside &= sidesOutside(clipFromFixed.apply(corner(box, corner)));
    }
    return outside == 0;
  }

  private static Vector3 corner(Box3 box, int index) {
    return new Vector3(
        ((index & 1) == 0 ? box.low() : box.high()).x(), ((index & 2) == 0 ? box.low() : box.high()).y(),
        ((index & 4) == 0 ? box.low() : box.high()).z());
  }

  private static int sidesOutside(double[] clip) {
    int sides = 0;
    for (int axis = 0; axis < 3; axis++) {
      sides |= (clip[axis] < -clip[3] ? 1 : 0) << 2 * axis | (clip[axis] > clip[3] ? 1 : 0) << 2 * axis + 1;
    }
    return sides;
  }

  /**
   * How far ahead a place is.
   *
   * @param place in the fixed frame
   * @return metres along the line of sight
   */
  public double depth(Vector3 place) {
    return eyeFromFixed.apply(place).x();
  }

  /**
   * The place that is seen at a pixel.
   *
   * @param x pixels from the left
   * @param y pixels from the top
   * @param depth 0 at the near end to 1 at the far end, as OpenGL keeps it
   * @param eye of the picture
   * @return in the fixed frame, metres
   */
  public Vector3 place(int x, int y, double depth, Eye eye) {
    double ahead = ahead(depth, eye.near(), eye.far());
    double metres = (perspective ? ahead : 1) / reach;
    Vector3 inEye = new Vector3(ahead, (width / 2.0 - x - 0.5) * metres, (height / 2.0 - y - 0.5) * metres);
    return eye.fixedFromEye().apply(inEye);
  }

  private double ahead(double depth, double near, double far) {
    return perspective ? near * far / (far - depth * (far - near)) : near + depth * (far - near);
  }
}
