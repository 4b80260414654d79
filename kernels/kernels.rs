// Generated from constraints/ by hardpoint-codegen; changes here are lost.
// Rewrite with: cargo run -p hardpoint-codegen -- write

include!("bushing_angles.rs");
include!("bushing_angles_torque.rs");
include!("bushing_rotation_vector.rs");
include!("bushing_rotation_vector_torque.rs");
include!("bushing_translation.rs");
include!("displacement.rs");
include!("distance.rs");
include!("euler_parameters.rs");
include!("force_in_body.rs");
include!("moment_in_body.rs");
include!("moment_in_space.rs");
include!("orthogonal_1.rs");
include!("orthogonal_2.rs");
include!("patch_height.rs");
include!("point_height.rs");
include!("position_along.rs");
include!("rack_and_pinion.rs");
include!("rotation.rs");
include!("spherical.rs");
include!("squared_distance.rs");
include!("torsion.rs");
include!("rigid_body.rs");
/// The relations, one for each file of `constraints/` that states a residual.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RelationKind {
    /// Tait–Bryan angles in a bushing: (a, b, c) = 0, Bᵀ A_iᵀ A_j B_j = R_x(a) R_y(b) R_z(c), B = [x_i y_i z_i], B_j = [x_j y_j z_j]
    BushingAngles,
    /// Tait–Bryan angles in a bushing, with torques about its axes: (a, b, c) = 0, Bᵀ A_iᵀ A_j B_j = R_x(a) R_y(b) R_z(c); torques about B = [x_i y_i z_i], B_j = [x_j y_j z_j]
    BushingAnglesTorque,
    /// Rotation vector in a bushing: Bᵀ θ = 0, A_iᵀ A_j the rotation by |θ| about θ, B = [x_i y_i z_i]
    BushingRotationVector,
    /// Rotation vector in a bushing, with torques about its axes: Bᵀ θ = 0, A_iᵀ A_j the rotation by |θ| about θ; torques about B = [x_i y_i z_i]
    BushingRotationVectorTorque,
    /// Displacement in a bushing: Bᵀ A_iᵀ (r_j + A_j s_j − r_i − A_i s_i) = 0, B = [x_i y_i z_i]
    BushingTranslation,
    /// Prescribed coordinate of a point: (A_i a_i)ᵀ (r_j + A_j s_j − r_i − A_i s_i) − c = 0
    Displacement,
    /// Distance of two points: |d_ij| − l = 0, d_ij = r_j + A_j s_j − r_i − A_i s_i
    Distance,
    /// Normalisation of Euler parameters: pᵀp − 1 = 0
    EulerParameters,
    /// Force fixed in the body: a virtual displacement (A a)ᵀ (δr + δθ × A s); the multiplier is the force along −A a at the point s
    ForceInBody,
    /// Moment fixed in the body: a virtual rotation (A a)ᵀ δθ; the multiplier is the moment about −A a
    MomentInBody,
    /// Moment fixed in space: a virtual rotation aᵀ δθ; the multiplier is the moment about −a
    MomentInSpace,
    /// Orthogonal, type 1: (A_i u_i)ᵀ (A_j v_j) = 0
    Orthogonal1,
    /// Orthogonal, type 2: (A_i a_i)ᵀ (r_j + A_j s_j − r_i − A_i s_i) = 0
    Orthogonal2,
    /// Prescribed height of the tyre contact patch: e_zᵀ (r + A s) − R √(1 − (e_zᵀ A u)²) − z = 0
    PatchHeight,
    /// Prescribed height of a point: e_zᵀ (r + A s) − z = 0
    PointHeight,
    /// Position of a point along a fixed direction: aᵀ (r + A s) − c = 0
    PositionAlong,
    /// Rack and pinion: sin(θ − κ s) = 0, with cos θ = (A_i u_i)ᵀ A_j w_j, sin θ = (A_i v_i)ᵀ A_j w_j and s = (A_i a_i)ᵀ (r_j + A_j s_j − r_i − A_i s_i)
    RackAndPinion,
    /// Prescribed angle about an axis: sin(θ − α) = 0, with cos θ = (A_i u_i)ᵀ A_j w_j and sin θ = (A_i v_i)ᵀ A_j w_j
    Rotation,
    /// Spherical joint: r_j + A_j s_j − r_i − A_i s_i = 0
    Spherical,
    /// Constant distance, squared: d_ijᵀ d_ij − l² = 0, d_ij = r_j + A_j s_j − r_i − A_i s_i
    SquaredDistance,
    /// Angle about an axis: atan2((A_i w_i)ᵀ A_j u_j, (A_i u_i)ᵀ A_j u_j) − α = 0
    Torsion,
}
impl RelationKind {
    /// All of them in the order of their names.
    pub const ALL: &'static [Self] = &[
        Self::BushingAngles,
        Self::BushingAnglesTorque,
        Self::BushingRotationVector,
        Self::BushingRotationVectorTorque,
        Self::BushingTranslation,
        Self::Displacement,
        Self::Distance,
        Self::EulerParameters,
        Self::ForceInBody,
        Self::MomentInBody,
        Self::MomentInSpace,
        Self::Orthogonal1,
        Self::Orthogonal2,
        Self::PatchHeight,
        Self::PointHeight,
        Self::PositionAlong,
        Self::RackAndPinion,
        Self::Rotation,
        Self::Spherical,
        Self::SquaredDistance,
        Self::Torsion,
    ];
    /// The name of the file, without its ending.
    pub fn name(self) -> &'static str {
        self.shape().name
    }
    /// What the file of this name states.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "bushing_angles" => Some(Self::BushingAngles),
            "bushing_angles_torque" => Some(Self::BushingAnglesTorque),
            "bushing_rotation_vector" => Some(Self::BushingRotationVector),
            "bushing_rotation_vector_torque" => Some(Self::BushingRotationVectorTorque),
            "bushing_translation" => Some(Self::BushingTranslation),
            "displacement" => Some(Self::Displacement),
            "distance" => Some(Self::Distance),
            "euler_parameters" => Some(Self::EulerParameters),
            "force_in_body" => Some(Self::ForceInBody),
            "moment_in_body" => Some(Self::MomentInBody),
            "moment_in_space" => Some(Self::MomentInSpace),
            "orthogonal_1" => Some(Self::Orthogonal1),
            "orthogonal_2" => Some(Self::Orthogonal2),
            "patch_height" => Some(Self::PatchHeight),
            "point_height" => Some(Self::PointHeight),
            "position_along" => Some(Self::PositionAlong),
            "rack_and_pinion" => Some(Self::RackAndPinion),
            "rotation" => Some(Self::Rotation),
            "spherical" => Some(Self::Spherical),
            "squared_distance" => Some(Self::SquaredDistance),
            "torsion" => Some(Self::Torsion),
            _ => None,
        }
    }
    /// Patterns, parameters and operation counts.
    pub fn shape(self) -> &'static Shape {
        match self {
            Self::BushingAngles => &bushing_angles::SHAPE,
            Self::BushingAnglesTorque => &bushing_angles_torque::SHAPE,
            Self::BushingRotationVector => &bushing_rotation_vector::SHAPE,
            Self::BushingRotationVectorTorque => &bushing_rotation_vector_torque::SHAPE,
            Self::BushingTranslation => &bushing_translation::SHAPE,
            Self::Displacement => &displacement::SHAPE,
            Self::Distance => &distance::SHAPE,
            Self::EulerParameters => &euler_parameters::SHAPE,
            Self::ForceInBody => &force_in_body::SHAPE,
            Self::MomentInBody => &moment_in_body::SHAPE,
            Self::MomentInSpace => &moment_in_space::SHAPE,
            Self::Orthogonal1 => &orthogonal_1::SHAPE,
            Self::Orthogonal2 => &orthogonal_2::SHAPE,
            Self::PatchHeight => &patch_height::SHAPE,
            Self::PointHeight => &point_height::SHAPE,
            Self::PositionAlong => &position_along::SHAPE,
            Self::RackAndPinion => &rack_and_pinion::SHAPE,
            Self::Rotation => &rotation::SHAPE,
            Self::Spherical => &spherical::SHAPE,
            Self::SquaredDistance => &squared_distance::SHAPE,
            Self::Torsion => &torsion::SHAPE,
        }
    }
    /// The kernels for one type of number.
    pub fn kernels<S: Scalar>(self) -> &'static dyn Relation<S> {
        match self {
            Self::BushingAngles => &bushing_angles::BushingAngles,
            Self::BushingAnglesTorque => &bushing_angles_torque::BushingAnglesTorque,
            Self::BushingRotationVector => {
                &bushing_rotation_vector::BushingRotationVector
            }
            Self::BushingRotationVectorTorque => {
                &bushing_rotation_vector_torque::BushingRotationVectorTorque
            }
            Self::BushingTranslation => &bushing_translation::BushingTranslation,
            Self::Displacement => &displacement::Displacement,
            Self::Distance => &distance::Distance,
            Self::EulerParameters => &euler_parameters::EulerParameters,
            Self::ForceInBody => &force_in_body::ForceInBody,
            Self::MomentInBody => &moment_in_body::MomentInBody,
            Self::MomentInSpace => &moment_in_space::MomentInSpace,
            Self::Orthogonal1 => &orthogonal_1::Orthogonal1,
            Self::Orthogonal2 => &orthogonal_2::Orthogonal2,
            Self::PatchHeight => &patch_height::PatchHeight,
            Self::PointHeight => &point_height::PointHeight,
            Self::PositionAlong => &position_along::PositionAlong,
            Self::RackAndPinion => &rack_and_pinion::RackAndPinion,
            Self::Rotation => &rotation::Rotation,
            Self::Spherical => &spherical::Spherical,
            Self::SquaredDistance => &squared_distance::SquaredDistance,
            Self::Torsion => &torsion::Torsion,
        }
    }
}
/// The kinetic energies, one for each file of `constraints/` that states one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum EnergyKind {
    /// Rigid body: T = ½ m |ṙ + A (ω′ × s)|² + ½ ω′ᵀ J ω′, J = [Jxx Jxy Jxz; Jxy Jyy Jyz; Jxz Jyz Jzz]
    RigidBody,
}
impl EnergyKind {
    /// All of them in the order of their names.
    pub const ALL: &'static [Self] = &[Self::RigidBody];
    /// The name of the file, without its ending.
    pub fn name(self) -> &'static str {
        self.shape().name
    }
    /// What the file of this name states.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "rigid_body" => Some(Self::RigidBody),
            _ => None,
        }
    }
    /// Patterns, parameters and operation counts.
    pub fn shape(self) -> &'static EnergyShape {
        match self {
            Self::RigidBody => &rigid_body::SHAPE,
        }
    }
    /// The kernels for one type of number.
    pub fn kernels<S: Scalar>(self) -> &'static dyn KineticEnergy<S> {
        match self {
            Self::RigidBody => &rigid_body::RigidBody,
        }
    }
}
