package org.robotui.data.marker;

import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.internal.Check;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * Something that a robot wants to be shown in space. Numbers are as the robot sent them: a pose may be none (not
 * finite, or a rotation of no length), a scale zero. Who draws says what is wrong with which marker.
 *
 * @param key its name
 * @param frame the frame of its pose
 * @param stamp when its frame is looked up; empty for the newest time known
 * @param receivedNanos {@link System#nanoTime()} when it came, from which its lifetime counts
 * @param type what it looks like
 * @param pose frame from marker
 * @param scale its size, metres; what each number means depends on the type
 * @param color its colour
 * @param lifetimeNanos after which it goes by itself; 0 for never
 * @param locked true where it moves with its frame, false where it stays where the frame was when it came
 * @param points x, y, z in turn, in the marker's frame, for the types that have points
 * @param colors red, green, blue, alpha a point; empty where the marker has one colour
 * @param text what is read, for texts
 * @param mesh address of a mesh, for meshes
 * @param embeddedMaterials true where the mesh's own colours count
 */
public record Marker(
    Key key,
    FrameId frame,
    Optional<Stamp> stamp,
    long receivedNanos,
    Type type,
    RigidTransform pose,
    Vector3 scale,
    Color color,
    long lifetimeNanos,
    boolean locked,
    Floats points,
    Bytes colors,
    String text,
    String mesh,
    boolean embeddedMaterials) {
  /**
   * The name of a marker.
   *
   * @param namespace a group of markers
   * @param id within the group
   */
  public record Key(String namespace, int id) {
    @Override
    public String toString() {
      return namespace.isEmpty() ? String.valueOf(id) : namespace + "/" + id;
    }
  }

  /** What a marker looks like. */
  public enum Type {
    /**
     * Along x, scaled in length, width and height; or from the first to the second point with diameters of shaft and
     * head.
     */
    ARROW,
    /** A box with edges of the scale. */
    CUBE,
    /** An ellipsoid with diameters of the scale. */
    SPHERE,
    /** Along z, diameters and height of the scale. */
    CYLINDER,
    /** Each point to the next, as wide as the scale's x. */
    LINE_STRIP,
    /** The first point to the second, the third to the fourth, ..., as wide as the scale's x. */
    LINE_LIST,
    /** A box at each point. */
    CUBE_LIST,
    /** An ellipsoid at each point. */
    SPHERE_LIST,
    /** Flat points as wide as the scale's x. */
    POINTS,
    /** Text that faces the viewer, as high as the scale's z. */
    TEXT,
    /** A mesh from a file, scaled. */
    MESH,
    /** Three points each are a triangle. */
    TRIANGLE_LIST,
    /** A type that is not known here. */
    UNKNOWN
  }

  /**
   * Checks the sizes.
   *
   * @param key its name
   * @param frame of its pose
   * @param stamp of its frame
   * @param receivedNanos when it came
   * @param type its look
   * @param pose where it is
   * @param scale metres
   * @param color its colour
   * @param lifetimeNanos not negative
   * @param locked moves with its frame
   * @param points three numbers each
   * @param colors none, or four bytes a point
   * @param text of texts
   * @param mesh of meshes
   * @param embeddedMaterials of meshes
   */
  public Marker {
    Check.that(points.size() % 3 == 0, "points", "must have three numbers each, has " + points.size());
    Check.emptyOr(colors.size(), points.size() / 3 * 4, "colors");
    Check.notNegative(lifetimeNanos, "lifetime");
  }
}
