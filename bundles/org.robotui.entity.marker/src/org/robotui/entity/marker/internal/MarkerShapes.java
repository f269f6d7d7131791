package org.robotui.entity.marker.internal;

import java.util.List;
import java.util.Optional;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Shape;

/**
 * What a marker becomes, in its frame.
 *
 * @param pieces simple solids in the marker's colour, which are drawn together with those of other markers
 * @param own a shape of its own
 * @param mesh frame from mesh, where the marker is a mesh from a file
 * @param flaw what is wrong with the marker, empty where all is well; it may be seen all the same
 */
record MarkerShapes(List<Piece> pieces, Optional<Own> own, Optional<RigidTransform> mesh, String flaw) {
  /**
   * A simple solid.
   *
   * @param form what is repeated
   * @param at frame from solid
   * @param scale along the solid's axes
   */
  record Piece(Form form, RigidTransform at, Vector3 scale) {}

  /**
   * A shape of its own.
   *
   * @param shape what is drawn
   * @param at frame from shape
   * @param material how it looks
   */
  record Own(Shape shape, RigidTransform at, Material material) {}

  static MarkerShapes nothing(String flaw) {
    return new MarkerShapes(List.of(), Optional.empty(), Optional.empty(), flaw);
  }

  static MarkerShapes solid(Form form, RigidTransform at, Vector3 scale) {
    return new MarkerShapes(List.of(new Piece(form, at, scale)), Optional.empty(), Optional.empty(), "");
  }

  static MarkerShapes of(Shape shape, RigidTransform at, Material material) {
    return new MarkerShapes(List.of(), Optional.of(new Own(shape, at, material)), Optional.empty(), "");
  }

  static MarkerShapes mesh(RigidTransform at) {
    return new MarkerShapes(List.of(), Optional.empty(), Optional.of(at), "");
  }

  /** The same with something wrong, unless something was found before. */
  MarkerShapes but(String words) {
    return flaw.isEmpty() ? new MarkerShapes(pieces, own, mesh, words) : this;
  }
}
