package org.robotui.api.replay;

/**
 * Which recording: the robot interface that plays it.
 *
 * @param robot the robot whose recording it is
 * @param instance the id of the robot interface within its RUIC
 */
public record TrackId(String robot, String instance) {}
