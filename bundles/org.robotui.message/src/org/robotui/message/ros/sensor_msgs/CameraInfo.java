package org.robotui.message.ros.sensor_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Calibration of a camera ({@code sensor_msgs/CameraInfo}).
 *
 * @param header time of the image and optical frame
 * @param height rows of the calibrated image
 * @param width columns of the calibrated image
 * @param distortionModel such as {@code plumb_bob}
 * @param d distortion coefficients
 * @param k 3 x 3 intrinsic matrix of the raw image, row by row
 * @param r 3 x 3 rectification matrix, row by row
 * @param p 3 x 4 projection matrix, row by row
 * @param binningX columns joined into one; 0 means 1
 * @param binningY rows joined into one; 0 means 1
 * @param roi part of the full image; all zero means all of it
 */
@MessageType("sensor_msgs/CameraInfo")
public record CameraInfo(
    Header header, long height, long width, String distortionModel, double[] d, double[] k, double[] r, double[] p,
    long binningX, long binningY, RegionOfInterest roi) {}
