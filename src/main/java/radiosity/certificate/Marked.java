package radiosity.certificate;

import java.util.List;
import radiosity.protocol.Mark;

/**
 * Elements on which independent points err by more than interpolation on one element may. No vertex tells of a spot of
 * light or of a shadow that lies between the vertices; a point that meets it does.
 *
 * @param marks nodes to be divided: an element, or a part of it around the point where the error is several times what
 *              an element may have
 * @param share part of the estimated mean square error that lies on these elements, from 0 to 1
 */
public record Marked(List<Mark> marks, double share) { }
