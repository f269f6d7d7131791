package org.robotui.uic.map.internal.model;

import org.robotui.geometry.RigidTransform;
import org.robotui.ui.scene.PastSpot;

/**
 * Where a robot was at the time at which the user points.
 *
 * @param spot in a frame of the recording
 * @param fixedFromFrame where that frame is now
 * @param number gives the robot its colour among those of a team, from 0
 */
public record PastPlace(PastSpot spot, RigidTransform fixedFromFrame, int number) {}
